/** The survey of a rock image on a Spark cluster. */
package org.hdispatch.example.spark;
