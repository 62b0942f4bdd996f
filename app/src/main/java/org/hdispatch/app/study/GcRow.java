package org.hdispatch.app.study;

import java.util.Optional;

/**
 * How a run of the study ended.
 *
 * @param of what was run
 * @param why in one line, why there are no figures; empty if there are
 * @param figures what was measured; empty if the JVM died or refused to start
 * @param fork which of the runs of this case, from 1
 * @param origin what it was made with, and where
 */
public record GcRow(
    GcCase of, String why, Optional<GcFigures> figures, int fork, GcOrigin origin) {}
