/** What does it cost to hand a cell to a worker? */
package org.hdispatch.bench.dispatch;
