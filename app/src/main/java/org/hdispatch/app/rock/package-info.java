/**
 * Which rock, by which method and with which settings, as users say it; shared by all commands that
 * compute a flow through rock.
 */
package org.hdispatch.app.rock;
