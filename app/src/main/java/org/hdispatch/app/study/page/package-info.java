/** The page of the study of garbage collection: verdict, pictures, table. */
package org.hdispatch.app.study.page;
