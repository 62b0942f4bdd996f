/**
 * The command line {@code hdispatch}: the only part of H-Dispatch that prints.
 *
 * <pre>
 * HDispatch ──&gt; permeability, survey, lattice, particles, steady, gc      rooms of commands
 *                  │                       │                  │
 *                  │               survey.page, draw          └──&gt; study, study.page
 *                  v
 *            rock ──&gt; console &lt;── watch                                    what they share
 *                        │
 *                        v
 *                      text
 * </pre>
 *
 * <p>A command reads its options (mixins), computes with the other modules while {@code watch}
 * listens, and makes rows for programs ({@code FlatRow}) and tables for people. A study compares
 * runs and draws a page in the frame that any study can use, {@code StudyPage}.
 *
 * <p>The result goes to standard output and nothing else does; progress, warnings and errors go to
 * standard error, an error as one line ({@code Faults}).
 */
package org.hdispatch.app;
