/** A program that embeds the dispatcher. */
module org.hdispatch.example {
  requires org.hdispatch.core;
}
