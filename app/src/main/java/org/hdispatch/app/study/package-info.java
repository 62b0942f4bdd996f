/**
 * The study of garbage collection: what is run ({@link org.hdispatch.app.study.GcCase}), what is
 * measured ({@link org.hdispatch.app.study.GcFigures}), and the ways of keeping scratch that are
 * compared with enduring threads.
 */
package org.hdispatch.app.study;
