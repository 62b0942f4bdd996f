/** Plots, pictures and pages: SVG, PNG, HTML. */
package org.hdispatch.app.draw;
