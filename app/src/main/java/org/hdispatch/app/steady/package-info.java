/**
 * {@code steady-study}: how k comes to its steady value, with corrections of the pressure and
 * without.
 */
package org.hdispatch.app.steady;
