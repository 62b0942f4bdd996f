/**
 * A square duct, ready to run: the benchmark of Leonardi, Holmes, Williams, Tilke, HPC 2011, figure
 * 4, and the bandwidth of the memory measured beside it.
 *
 * <pre>
 * BandwidthProbe ──&gt; sweeps ─┐
 *                            ├──&gt; DuctRun ──&gt; DuctFigures
 * Duct ──&gt; LbmScheme ──&gt; steps ┘
 * </pre>
 */
package org.hdispatch.lbm.duct;
