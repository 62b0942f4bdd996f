package org.hdispatch.poisson;

/**
 * How a solve ended.
 *
 * @param iterations iterations done
 * @param relativeResidual norm of the residual by that of the (balanced) right-hand side
 * @param converged whether the tolerance was reached
 * @param imbalance the largest |sum of the sources| found in a cluster without a fixed side, in
 *     units of the sources; it was spread over the nodes of the cluster and taken away
 */
public record Convergence(
    int iterations, double relativeResidual, boolean converged, double imbalance) {}
