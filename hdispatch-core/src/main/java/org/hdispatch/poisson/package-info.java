/**
 * Conjugate gradients on the dispatcher: Poisson's equation on the active nodes of a box, in
 * hash-keyed cells.
 *
 * <pre>{@code
 * PoissonProblem problem =
 *     PoissonProblem.box(48, 48, 48)
 *         .mobility((x, y, z) -> x * y * z % 7 == 1 ? 0 : 1) // 0: no node there
 *         .fixed(Side.Z_FIRST, 1)
 *         .fixed(Side.Z_LAST, 0)
 *         .build();
 * try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
 *   ConjugateGradients solver = ConjugateGradients.on(dispatcher, problem);
 *   solver.addSources((x, y, z) -> z == 24 ? 1e-3 : 0);
 *   Convergence end = solver.solve(1e-8, 100);
 *   solver.forEachNode((x, y, z, p) -> pressure[x + 48 * (y + 48 * z)] = p);
 * }
 * }</pre>
 */
package org.hdispatch.poisson;
