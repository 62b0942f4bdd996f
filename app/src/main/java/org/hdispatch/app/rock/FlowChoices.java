package org.hdispatch.app.rock;

import org.hdispatch.app.console.Given;
import org.hdispatch.app.console.UsageException;
import org.hdispatch.porous.block.FlowChoice;
import org.hdispatch.porous.block.Method;
import org.hdispatch.porous.block.Walls;
import org.hdispatch.porous.flow.FlowOptions;
import org.hdispatch.porous.flow.SphOptions;

/** From options to a method and its settings. */
public final class FlowChoices {
  private FlowChoices() {}

  /**
   * The choice of the user; what was not given follows from the method and the walls.
   *
   * @throws UsageException if options do not go together, or one is out of its bounds
   */
  public static FlowChoice of(MethodOptions method, FlowSettings settings, Given given) {
    if (method.method() == Method.SPH) {
      MethodOptions.LBM_NAMES.forEach(name -> given.refuse(name, "--method lbm"));
    } else {
      MethodOptions.SPH_NAMES.forEach(name -> given.refuse(name, "--method sph"));
    }
    if (settings.walls() != Walls.IMB) {
      given.refuse("--solid-fraction-range", "--walls imb");
    }
    if (settings.solidFractionRange().isPresent()) {
      given.refuse("--pore-value", "a segmented image, not --solid-fraction-range");
    }
    FlowOptions options = settings.options();
    if (method.method() == Method.SPH && !given.has("--tolerance")) {
      options = options.withTolerance(MethodOptions.SPH_TOLERANCE);
    }
    if (settings.walls() == Walls.IMB) {
      if (!given.has("--lattice")) {
        options = options.withVelocitySet(FlowOptions.IMMERSED.velocitySet());
      }
      if (!given.has("--collision")) {
        options = options.withCollision(FlowOptions.IMMERSED.collision());
      }
    }
    FlowOptions chosen = options;
    SphOptions particles = method.particles();
    return UsageException.orRefused(() -> new FlowChoice(method.method(), chosen, particles));
  }
}
