/**
 * What all commands share: what they run in, where they print, the words and numbers of their
 * options, and how they end.
 */
package org.hdispatch.app.console;
