/** Numbers and tables as text. */
package org.hdispatch.app.text;
