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
 * <p>The result goes to standard output and nothing else does; progress, warnings and errors go to
 * standard error, an error as one line.
 */
package org.hdispatch.app;
