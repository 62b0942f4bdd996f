/**
 * Conjugate gradients on the dispatcher: Poisson's equation on the active nodes of a box, in
 * hash-keyed cells.
 *
 * <pre>{@code
 * PoissonProblem problem =
 *     PoissonProblem.box(nx, ny, nz)
 *         .mobility((x, y, z) -> open(x, y, z) ? 1 : 0)
 *         .fixed(Side.Z_FIRST, 1)
 *         .fixed(Side.Z_LAST, 0)
 *         .build();
 * try (Dispatcher dispatcher = Dispatcher.withWorkers(2)) {
 *   ConjugateGradients solver = ConjugateGradients.on(dispatcher, problem);
 *   Convergence end = solver.solve(1e-8, 100);
 *   solver.forEachNode((x, y, z, p) -> ...);
 * }
 * }</pre>
 */
package org.hdispatch.poisson;
