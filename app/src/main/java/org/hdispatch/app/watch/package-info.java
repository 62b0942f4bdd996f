/** What listens to a run: its progress, and what it leaves for the garbage collector. */
package org.hdispatch.app.watch;
