package org.hdispatch.app.study;

import java.util.Optional;

/**
 * How a run of the study ended.
 *
 * @param of what was run
 * @param why in one line, why there are no figures; empty if there are
 * @param figures what was measured; empty if the JVM died or refused to start
 */
public record GcRow(GcCase of, String why, Optional<GcFigures> figures) {}
