package org.hdispatch.app.permeability;

import java.util.concurrent.Callable;
import org.hdispatch.app.console.CommandConsole;
import org.hdispatch.app.console.ExitCode;
import org.hdispatch.app.console.Host;
import org.hdispatch.app.console.OutputFolder;
import org.hdispatch.app.console.OutputOptions;
import org.hdispatch.app.console.StandardOptions;
import org.hdispatch.app.rock.ImageOptions;
import org.hdispatch.app.rock.ImageSource;
import org.hdispatch.app.rock.Rock;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.hdispatch.porous.io.ImageFileException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code hdispatch inspect}: what an image is, before anything is computed. */
@Command(
    name = "inspect",
    description = {
      "Look at an image before computing: size, labels, porosity, percolation along each axis.",
      "Without IMAGE: the bundled sample of Berea sandstone.",
      "--output writes the three middle planes as PNG: pore blue, isolated pore orange, solid grey."
    })
public final class InspectCommand implements Callable<Integer> {
  private final Host host;

  @Mixin private final ImageOptions imageOptions = new ImageOptions();
  @Mixin private final OutputOptions output = new OutputOptions();
  @Mixin private final StandardOptions standard = new StandardOptions();
  @Spec private CommandSpec spec;

  /**
   * Makes the command.
   *
   * @param host what it runs in
   */
  public InspectCommand(Host host) {
    this.host = host;
  }

  @Override
  public Integer call() throws ImageFileException {
    output.folder();
    ImageSource source = ImageSource.of(imageOptions);
    VoxelBox box = Rock.boxOf(source, imageOptions.box());
    Inspection inspection =
        new Inspection(
            source, box, imageOptions.rule(), imageOptions.voxelEdgeOr(source.voxelEdge()));
    if (output.folder().isEmpty()) {
      look(inspection);
    } else {
      try (OutputFolder folder = OutputFolder.open(output.folder().get())) {
        look(inspection);
        inspection.draw(folder);
      }
    }
    return ExitCode.DONE.code();
  }

  private void look(Inspection inspection) throws ImageFileException {
    VoxelImage image = Rock.read(inspection.source(), inspection.box(), host);
    inspection.look(image);
    new CommandConsole(spec, host, output.quiet())
        .print(output.form(inspection.row(), inspection.table()));
  }
}
