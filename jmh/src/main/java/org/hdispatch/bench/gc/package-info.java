/**
 * What is left to the garbage collector, and what does that cost? One class, one question: scratch,
 * boxed keys, small objects, references in old objects. A dictionary of nodes beside flat bundles
 * is {@link org.hdispatch.bench.paper.PaperFormBenchmark}'s question, the collectors beside each
 * other on steps that leave nothing {@link org.hdispatch.bench.lbm.CollectorBenchmark}'s.
 */
package org.hdispatch.bench.gc;
