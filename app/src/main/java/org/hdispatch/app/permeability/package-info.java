/**
 * {@code inspect} and {@code permeability}: from an image to what it is, and to its permeability.
 */
package org.hdispatch.app.permeability;
