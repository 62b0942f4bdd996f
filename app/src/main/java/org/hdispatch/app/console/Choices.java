package org.hdispatch.app.console;

import java.util.Arrays;
import java.util.Iterator;
import java.util.Locale;
import org.hdispatch.dispatch.ScratchLifetime;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.Storage;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.immersed.SettlingSphere;
import org.hdispatch.porous.block.Method;
import org.hdispatch.porous.block.Outside;
import org.hdispatch.porous.block.Walls;
import org.hdispatch.porous.flow.Approach;
import org.hdispatch.porous.flow.CollisionModel;
import org.hdispatch.porous.flow.Inlet;
import org.hdispatch.porous.flow.Sides;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.SpherePacking;
import org.hdispatch.porous.survey.ReferenceBand;
import org.hdispatch.sph.SearchMode;
import org.hdispatch.sph.SumForm;
import picocli.CommandLine.TypeConversionException;

/** The words for the values of an enumeration: its names in lower case, hyphens between words. */
public abstract class Choices implements Iterable<String> {
  private final Enum<?>[] values;

  /**
   * Makes the words.
   *
   * @param values of the enumeration, in their order
   */
  public Choices(Enum<?>[] values) {
    this.values = values;
  }

  /** The word for a value. */
  public static String word(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /**
   * The value of a word.
   *
   * @throws TypeConversionException if there is none
   */
  public static <E extends Enum<E>> E value(E[] values, String text) {
    for (E each : values) {
      if (word(each).equalsIgnoreCase(text)) {
        return each;
      }
    }
    throw new TypeConversionException(text);
  }

  @Override
  public Iterator<String> iterator() {
    return Arrays.stream(values).map(Choices::word).iterator();
  }

  /** Words for approaches. */
  public static final class OfApproach extends Choices {
    OfApproach() {
      super(Approach.values());
    }
  }

  /** Words for axes. */
  public static final class OfAxis extends Choices {
    OfAxis() {
      super(Axis.values());
    }
  }

  /** Words for collisions. */
  public static final class OfCollision extends Choices {
    OfCollision() {
      super(CollisionModel.values());
    }
  }

  /** Words for methods. */
  public static final class OfMethod extends Choices {
    OfMethod() {
      super(Method.values());
    }
  }

  /** Words for sides. */
  public static final class OfSides extends Choices {
    OfSides() {
      super(Sides.values());
    }
  }

  /** Words for inlets. */
  public static final class OfInlet extends Choices {
    OfInlet() {
      super(Inlet.values());
    }
  }

  /** Words for walls. */
  public static final class OfWalls extends Choices {
    OfWalls() {
      super(Walls.values());
    }
  }

  /** Words for the oils of the settling sphere. */
  public static final class OfFluid extends Choices {
    OfFluid() {
      super(SettlingSphere.Fluid.values());
    }
  }

  /** Words for sphere packings. */
  public static final class OfSpheres extends Choices {
    OfSpheres() {
      super(SpherePacking.values());
    }
  }

  /** Words for ways of streaming. */
  public static final class OfStreaming extends Choices {
    OfStreaming() {
      super(Streaming.values());
    }
  }

  /** Words for precisions. */
  public static final class OfStorage extends Choices {
    OfStorage() {
      super(Storage.values());
    }
  }

  /** Words for forms of the kernel. */
  public static final class OfKernel extends Choices {
    OfKernel() {
      super(KernelForm.values());
    }
  }

  /** Words for what is done with blocks that reach outside the sample. */
  public static final class OfOutside extends Choices {
    OfOutside() {
      super(Outside.values());
    }
  }

  /** Words for reference bands. */
  public static final class OfBands extends Choices {
    OfBands() {
      super(ReferenceBand.values());
    }
  }

  /** Words for searches of neighbours. */
  public static final class OfSearch extends Choices {
    OfSearch() {
      super(SearchMode.values());
    }
  }

  /** Words for forms of the sums over neighbours. */
  public static final class OfSums extends Choices {
    OfSums() {
      super(SumForm.values());
    }
  }

  /** Words for lifetimes of scratch. */
  public static final class OfLifetimes extends Choices {
    OfLifetimes() {
      super(ScratchLifetime.values());
    }
  }
}
