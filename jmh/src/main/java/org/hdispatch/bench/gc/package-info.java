/** What is it worth that scratch endures? */
package org.hdispatch.bench.gc;
