package org.hdispatch.porous.flow;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.hdispatch.cell.Ends;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.pore.PoreSpace;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PoreWidthTest {
  @ParameterizedTest
  @CsvSource({"5,4,3", "1,6,2", "2,1,7", "4,2,1"})
  void countsTheWallFacesOfEveryPoreVoxel(int nx, int ny, int nz) {
    for (int seed = 0; seed < 20; seed++) {
      Random random = new Random(seed);
      PoreSpace rock = PoreSpace.of(nx, ny, nz, (x, y, z) -> random.nextInt(3) > 0);
      for (Axis axis : Axis.values()) {
        for (Sides sides : Sides.values()) {
          for (Inlet inlet : Inlet.values()) {
            FlowOptions options = FlowOptions.DEFAULT.withAxis(axis).withBoundaries(sides, inlet);
            long faces = wallFaces(rock, options);
            if (faces > 0 && rock.poreVoxels() > 0) {
              assertEquals(
                  4.0 * rock.poreVoxels() * 1.5 / faces,
                  PoreWidth.hydraulicDiameter(rock, options),
                  1e-12,
                  options + ", seed " + seed);
            }
          }
        }
      }
    }
  }

  /** Voxel by voxel, face by face. */
  private static long wallFaces(PoreSpace rock, FlowOptions options) {
    long faces = 0;
    for (int n = 0; n < rock.voxels(); n++) {
      int[] at = {n % rock.nx(), n / rock.nx() % rock.ny(), n / rock.nx() / rock.ny()};
      for (int side = 0; side < 6 && rock.isPore(n); side++) {
        Axis across = Axis.values()[side / 2];
        boolean along = across == options.axis();
        Ends ends = along ? options.inlet().ends() : options.sides().ends();
        int[] beside = at.clone();
        int extent = across.length(rock.nx(), rock.ny(), rock.nz());
        beside[side / 2] = ends.wrap(at[side / 2] + 2 * (side % 2) - 1, extent);
        boolean outside = beside[side / 2] < 0;
        boolean wall =
            outside
                ? !along && options.sides() == Sides.WALL
                : !rock.isPore(beside[0], beside[1], beside[2]);
        faces += wall ? 1 : 0;
      }
    }
    return faces;
  }
}
