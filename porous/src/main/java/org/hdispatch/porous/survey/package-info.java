/**
 * The survey of an image: which blocks are cut out of it, in which order, and the rows of what was
 * found in them.
 *
 * <p>A <em>job</em> is a block and an axis. Jobs are numbered, need nothing of each other, and may
 * be done by several processes, each a {@link org.hdispatch.porous.survey.Shard}. What a job finds
 * is one {@link org.hdispatch.porous.survey.SurveyRow} of a file that only grows, so that a process
 * that is killed loses the job in work and no other.
 */
package org.hdispatch.porous.survey;
