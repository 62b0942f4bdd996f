/**
 * {@code survey}, {@code survey-report} and {@code upscale}: the blocks of an image, from the plan
 * to the sample.
 */
package org.hdispatch.app.survey;
