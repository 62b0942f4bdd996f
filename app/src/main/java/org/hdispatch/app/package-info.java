/**
 * The command line {@code hdispatch}: the only part of H-Dispatch that prints.
 *
 * <pre>
 * HDispatch ── commands ──&gt; options (mixins) ──&gt; ImageSource, Rock
 *     │            │                                   │
 *   Faults         └──────&gt; porous.flow.LbmFlow &lt;──────┘
 * (exit codes)                    │ ProgressLine, CollectorWatch listen
 *                                 v
 *                              Outcome ──&gt; OutcomeRow (JSON, CSV), OutcomeTable (text), OutputFolder
 * </pre>
 *
 * <p>A study compares runs and draws a page: {@code SteadyStudy} makes a {@code SteadyResult},
 * {@code SteadyReport} and {@code SteadyVerdict} say what is in it, and {@code SteadyPage} puts
 * that and its {@code LogPlot}s into the frame that any study can use, {@code StudyPage}.
 *
 * <p>The result goes to standard output and nothing else does; progress, warnings and errors go to
 * standard error, an error as one line.
 */
package org.hdispatch.app;
