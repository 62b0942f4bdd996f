package org.hdispatch.app.lattice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import org.hdispatch.app.Cli;
import org.hdispatch.app.console.Host;
import org.junit.jupiter.api.Test;

class SettleCommandTest {
  /** Four nodes across a sphere are few: within a tenth of the measurement. */
  @Test
  void comparesWithTheMeasurement() {
    Map<String, String> row =
        Cli.json("settle", "--fluid", "e4", "--nodes-across", 4, "--threads", 2, "--json");
    assertEquals("0.1222", row.get("peak_velocity_measured_m_s"));
    assertEquals(0, Double.parseDouble(row.get("deviation")), 0.1);
    assertEquals("\"e4\"", row.get("fluid"));
  }

  @Test
  void printsATable() {
    Cli run = Cli.run("settle", "--fluid", "E4", "--nodes-across", 3, "--threads", 2);
    assertEquals(0, run.code(), run.err());
    assertTrue(run.out().contains("m/s, measured 0.1222 m/s ("), run.out());
  }

  @Test
  void refusesWhatCannotBe() {
    Cli.run("settle", "--fluid", "e5").assertRefused(2, "e1, e2, e3, e4");
    Cli.run("settle", "--nodes-across", 2).assertRefused(2, "nodes=2");
    Cli.run("settle", "--threads", 0).assertRefused(2, "threads=0");
    Cli.run(new Host(1 << 20, false), "settle").assertRefused(5, "a box of");
  }
}
