package org.hdispatch.porous.io;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.zip.ZipInputStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import org.hdispatch.porous.image.VoxelBox;
import org.hdispatch.porous.image.VoxelImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TiffImagesTest {
  @TempDir Path folder;

  private Path write(String name, byte[] bytes) throws IOException {
    return Files.write(folder.resolve(name), bytes);
  }

  private Path write(TiffBytes tiff) throws IOException {
    return write("image.tif", tiff.bytes());
  }

  private static int[] slice(int z) {
    int[] samples = new int[6];
    for (int i = 0; i < 6; i++) {
      samples[i] = SmallImage.label(i % 2, i / 2, z);
    }
    return samples;
  }

  /** The small image, a page for each slice. */
  private static TiffBytes small(TiffBytes tiff, int bits) {
    for (int z = 0; z < 4; z++) {
      tiff.page(2, 3, bits, slice(z));
    }
    return tiff;
  }

  private static TiffBytes small() {
    return small(new TiffBytes(), 8);
  }

  private static String refusal(Path file) {
    return SmallImage.refusal(() -> TiffImages.open(file), file);
  }

  @ParameterizedTest
  @CsvSource({
    "8, 1, 1, false", "8, 1, 8, false", "8, 2, 8, true", "8, 1, 32773, false", "16, 1, 1, false",
    "16, 1, 8, false", "16, 2, 8, true", "16, 1, 32773, true", "32, 1, 1, true", "32, 2, 8, false"
  })
  void everyBoxOfEveryKindIsRead(int bits, int predictor, int compression, boolean tiled)
      throws IOException {
    for (ByteOrder order : new ByteOrder[] {ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN}) {
      for (boolean big : new boolean[] {false, true}) {
        TiffBytes tiff = new TiffBytes().tag(TiffBytes.COMPRESSION, compression);
        tiff.order = order;
        tiff.big = big;
        tiff.tag(TiffBytes.PREDICTOR, predictor);
        if (tiled) {
          tiff.tag(TiffBytes.TILE_WIDTH, 16).tag(TiffBytes.TILE_HEIGHT, 16);
        } else {
          tiff.tag(TiffBytes.ROWS_PER_STRIP, 2); // the last strip is shorter
        }
        ImageFile image = TiffImages.open(write(small(tiff, bits)));
        SmallImage.assertEveryBox(image);
        assertEquals(big ? "BigTIFF" : "TIFF", image.facts().get("format"));
        assertEquals("uint" + bits, image.facts().get("type"));
        assertEquals(4, image.facts().get("pages"));
        assertTrue(image.voxelEdge().isEmpty());
      }
    }
  }

  @ParameterizedTest
  @CsvSource({
    "1, 1, false",
    "2, 1, true",
    "4, 1, false",
    "1, 8, true",
    "2, 32773, false",
    "8, 1, true",
    "8, 8, true",
    "16, 1, true"
  })
  void boxesOfMoreThanOneBlockEqualTheCropOfTheWhole(int bits, int compression, boolean tiled)
      throws IOException {
    Random random = new Random(7);
    byte[] labels = new byte[37 * 23 * 2];
    TiffBytes tiff = new TiffBytes().tag(TiffBytes.COMPRESSION, compression);
    if (tiled) {
      tiff.tag(TiffBytes.TILE_WIDTH, 16).tag(TiffBytes.TILE_HEIGHT, 8);
    } else {
      tiff.tag(TiffBytes.ROWS_PER_STRIP, 5);
    }
    for (int z = 0; z < 2; z++) {
      int[] samples = new int[37 * 23];
      for (int i = 0; i < samples.length; i++) {
        samples[i] = random.nextInt(1 << Math.min(bits, 8));
        labels[i + z * samples.length] = (byte) samples[i];
      }
      tiff.page(37, 23, bits, samples);
    }
    ImageFile image = TiffImages.open(write(tiff));
    VoxelImage expected = VoxelImage.of(37, 23, 2, labels);
    assertArrayEquals(labels, image.read(image.whole()).toLabels());
    for (int i = 0; i < 200; i++) {
      int x0 = random.nextInt(37);
      int y0 = random.nextInt(23);
      int z0 = random.nextInt(2);
      VoxelBox box =
          new VoxelBox(
              x0,
              y0,
              z0,
              1 + random.nextInt(37 - x0),
              1 + random.nextInt(23 - y0),
              1 + random.nextInt(2 - z0));
      assertArrayEquals(expected.crop(box).toLabels(), image.read(box).toLabels(), box.toString());
    }
  }

  /** The JDK's writer knows nothing of ours; a page of noise fills LZW's table several times. */
  @ParameterizedTest
  @ValueSource(strings = {"", "LZW", "ZLib", "Deflate", "PackBits"})
  void whatTheJdkWritesIsRead(String compression) throws IOException {
    Path file = folder.resolve("jdk.tif");
    byte[] labels = new byte[300 * 200];
    Random random = new Random(5);
    for (int i = 0; i < labels.length; i++) {
      labels[i] = (byte) (i < labels.length / 2 ? random.nextInt(256) : i / 1000);
    }
    BufferedImage page = new BufferedImage(300, 200, BufferedImage.TYPE_BYTE_GRAY);
    byte[] pixels = ((DataBufferByte) page.getRaster().getDataBuffer()).getData();
    System.arraycopy(labels, 0, pixels, 0, labels.length);
    ImageWriter writer = ImageIO.getImageWritersByFormatName("tiff").next();
    ImageWriteParam param = writer.getDefaultWriteParam();
    if (!compression.isEmpty()) {
      param.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
      param.setCompressionType(compression);
    }
    param.setTilingMode(ImageWriteParam.MODE_EXPLICIT);
    param.setTiling(304, 208, 0, 0); // one block, so that the table of LZW overflows
    try (ImageOutputStream out = ImageIO.createImageOutputStream(file.toFile())) {
      writer.setOutput(out);
      writer.write(null, new IIOImage(page, null, null), param);
    } finally {
      writer.dispose();
    }
    ImageFile image = TiffImages.open(file);
    assertEquals(VoxelBox.whole(300, 200, 1), image.whole());
    assertArrayEquals(labels, image.read(image.whole()).toLabels());
  }

  @ParameterizedTest
  @CsvSource({"0, '1 bit, 0 = white'", "1, 1 bit", "3, '1 bit, palette'"})
  void labelsAreTheNumbersAsTheyAreStored(int photometric, String type) throws IOException {
    TiffBytes tiff = new TiffBytes().tag(TiffBytes.PHOTOMETRIC, photometric);
    ImageFile image = TiffImages.open(write(tiff.page(3, 1, 1, new int[] {0, 1, 1})));
    assertArrayEquals(new byte[] {0, 1, 1}, image.read(image.whole()).toLabels());
    assertEquals(type, image.facts().get("type"));
  }

  @Test
  void labelsThatDoNotFitAreRefusedWithTheirValue() throws IOException {
    Path file = write(new TiffBytes().page(2, 1, 16, new int[] {1, 1000}));
    assertEquals(
        "labels must be within 0..255 (map them to uint8): file="
            + file
            + ", page=0, type=uint16, label=1000",
        refusal(file));
    TiffBytes signed = new TiffBytes().tag(TiffBytes.SAMPLE_FORMAT, 2);
    assertTrue(
        refusal(write(signed.page(2, 1, 8, new int[] {1, -1})))
            .endsWith("page=0, type=int8, label=-1"));
  }

  @Test
  void folderIsReadInTheOrderOfTheNumbersInItsNames() throws IOException {
    for (int z = 0; z < 4; z++) {
      write("slice" + (z + 8) + ".tif", new TiffBytes().page(2, 3, 8, slice(z)).bytes());
    }
    write("notes.txt", new byte[3]);
    write(".hidden.tif", new byte[3]);
    ImageFile image = TiffImages.open(folder);
    SmallImage.assertEveryBox(image);
    assertEquals("slice8.tif", image.facts().get("first_slice"));
    assertEquals("slice11.tif", image.facts().get("last_slice"));
    assertEquals(4, image.facts().get("slices"));
  }

  @Test
  void foldersThatAreNoStackAreRefused() throws IOException {
    assertTrue(refusal(folder).startsWith("folder must hold the slices of an image (.tif, .tiff)"));
    byte[] slice = new TiffBytes().page(2, 3, 8, slice(0)).bytes();
    write("slice8.tif", slice);
    write("slice9.tif", slice);
    write("slice11.tif", slice);
    assertEquals(
        "slices must be numbered without a gap: file="
            + folder
            + ", slices=slice9.tif and slice11.tif",
        refusal(folder));
    Path other = write("slice10.tif", new TiffBytes().page(3, 2, 8, slice(0)).bytes());
    assertTrue(
        SmallImage.refusal(() -> TiffImages.open(folder), other)
            .endsWith("slice10.tif, found=3x2 uint8, first=2x3 uint8"));
    write("slice10.tif", small().bytes());
    assertTrue(
        SmallImage.refusal(() -> TiffImages.open(folder), other)
            .startsWith("slices in a folder must have one page each"));
  }

  @ParameterizedTest
  @CsvSource({
    "raw_0000, raw_0009, seg_0000", "rock1_0000, rock1_0001, rock2_0000",
    "a1_1, a1_2, a2_2", "overview, raw_0000, raw_0001"
  })
  void slicesOfTwoSeriesAreRefused(String first, String second, String third) throws IOException {
    byte[] slice = new TiffBytes().page(2, 3, 8, slice(0)).bytes();
    write(first + ".tif", slice);
    write(second + ".tif", slice);
    write(third + ".tif", slice);
    String foreign =
        first.equals("overview") ? "overview.tif and raw_0000" : second + ".tif and " + third;
    assertEquals(
        "slices must be of one series: folder=" + folder + ", slices=" + foreign + ".tif",
        assertThrows(ImageFileException.class, () -> TiffImages.open(folder)).getMessage());
  }

  @Test
  void slicesWithAnotherNumberInAllNamesAreOfOneSeries() throws IOException {
    for (int z = 0; z < 4; z++) {
      byte[] slice = new TiffBytes().page(2, 3, 8, slice(z)).bytes();
      write("rock2_" + (z + 8) + "_8bit.tif", slice);
    }
    SmallImage.assertEveryBox(TiffImages.open(folder));
  }

  @Test
  void slicesWithoutNumbersAreReadByTheirNames() throws IOException {
    for (int z = 0; z < 4; z++) {
      write("abcd".charAt(z) + ".tif", new TiffBytes().page(2, 3, 8, slice(z)).bytes());
    }
    SmallImage.assertEveryBox(TiffImages.open(folder));
  }

  @Test
  void pagesMustBeAlike() throws IOException {
    Path file = write(small().page(3, 2, 8, slice(0)));
    assertEquals(
        "all pages must be of one size and type: file="
            + file
            + ", page=4, found=3x2 uint8, first=2x3 uint8",
        refusal(file));
    assertTrue(refusal(write(small().page(2, 3, 16, slice(0)))).contains("found=2x3 uint16"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "262 | 2 | pages must be grey, palette or bilevel (convert colours to 8-bit grey): ",
        "277 | 3 | pages must be grey, palette or bilevel",
        "339 | 3 | labels must be integers of 0..255 (convert the pages to 8 bit): ",
        "259 | 7 | pages must be uncompressed, or packed by LZW, Deflate or PackBits",
        "266 | 2 | pages must keep the first pixel in the highest bits",
      })
  void pagesOfOtherKindsAreRefused(int tag, int value, String line) throws IOException {
    Path file = write(new TiffBytes().tag(tag, value).page(2, 3, 8, slice(0)));
    assertTrue(refusal(file).startsWith(line), refusal(file));
  }

  @Test
  void imagesThatImageJLeavesWithoutPagesAreRefused() throws IOException {
    TiffBytes tiff = new TiffBytes();
    tiff.description = "ImageJ=1.53t\nimages=1940\nslices=1940\n";
    Path file = write(small(tiff, 8));
    assertTrue(refusal(file).startsWith("file must have a page for each of ImageJ's images"));
    assertTrue(refusal(file).endsWith("pages=4, images=1940"));
    tiff = new TiffBytes();
    tiff.description = "ImageJ=1.53t\nimages=4\nslices=4\n";
    SmallImage.assertEveryBox(TiffImages.open(write(small(tiff, 8))));
  }

  @ParameterizedTest
  @ValueSource(strings = {"channels=2", "frames=4", "frames=10"})
  void channelsAndFramesOfImageJAreRefused(String noSlices) throws IOException {
    TiffBytes tiff = new TiffBytes();
    tiff.description = "ImageJ=1.53t\nimages=4\n" + noSlices + "\nhyperstack=true\n";
    Path file = write(small(tiff, 8));
    assertTrue(refusal(file).startsWith("ImageJ's images must be slices"), refusal(file));
    assertTrue(refusal(file).endsWith("file=" + file + ", " + noSlices), refusal(file));
    tiff = new TiffBytes();
    tiff.description = "ImageJ=1.53t\nimages=4\nchannels=1\nslices=4\nframes=1\n";
    SmallImage.assertEveryBox(TiffImages.open(write(small(tiff, 8))));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 8, 32773})
  void noFileThatIsCutShortIsRead(int compression) throws IOException {
    byte[] whole = small(new TiffBytes().tag(TiffBytes.COMPRESSION, compression), 8).bytes();
    for (int length = 1; length < whole.length; length++) {
      Path cut = write("cut.tif", Arrays.copyOf(whole, length));
      refusal(cut);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {8, 32773})
  void stripsThatEndTooEarlyAreRefused(int compression) throws IOException {
    // The second page says that it has more rows than its strip has.
    byte[] bytes =
        new TiffBytes().tag(TiffBytes.COMPRESSION, compression).page(2, 3, 8, slice(0)).bytes();
    for (int i = 0; i < bytes.length - 12; i++) {
      if (bytes[i] == 1 && bytes[i + 1] == 1 && bytes[i + 2] == 3 && bytes[i + 4] == 1) {
        bytes[i + 8] = 4; // ImageLength
      }
    }
    String refusal = refusal(write("image.tif", bytes));
    assertTrue(
        refusal.startsWith("strip must unpack to its full size (the file is damaged)"), refusal);
    assertTrue(refusal.endsWith("page=0, bytes=6, full=8"), refusal);
  }

  @Test
  void noDamageThrowsAnythingElse() throws IOException {
    byte[] whole = small(new TiffBytes().tag(TiffBytes.COMPRESSION, 8), 8).bytes();
    Random random = new Random(3);
    int refused = 0;
    for (int i = 0; i < 3000; i++) {
      byte[] damaged = whole.clone();
      damaged[random.nextInt(damaged.length)] ^= (byte) (1 << random.nextInt(8));
      Path file = write("damaged.tif", damaged);
      try {
        ImageFile image = TiffImages.open(file);
        if (image.whole().voxels() < 1 << 20) {
          image.read(image.whole());
        }
      } catch (ImageFileException e) {
        refused++;
      }
    }
    assertTrue(refused > 1000, refused + " refused"); // else the damage missed what is read
  }

  @Test
  void pagesThatLeadBackAreRefused() throws IOException {
    TiffBytes tiff = small();
    byte[] bytes = tiff.bytes();
    System.arraycopy(bytes, tiff.link(1), bytes, tiff.link(3), 4);
    Path file = write("loop.tif", bytes);
    assertTrue(refusal(file).startsWith("pages must not lead back to an earlier one: file="));
  }

  @Test
  void whatIsNoTiffIsRefused() throws IOException {
    assertTrue(refusal(write("a.tif", "no TIFF, this".getBytes())).startsWith("file must be TIFF"));
    assertTrue(refusal(folder.resolve("none.tif")).startsWith("file must exist"));
    assertTrue(
        refusal(write("b.tif", new byte[] {'I', 'I', 42, 0, 0, 0, 0, 0}))
            .startsWith("file must have a page"));
  }

  @ParameterizedTest
  @CsvSource({"berea, 400", "ketton, 256"})
  void publishedStacksEqualTheirRawImages(String rock, int n) throws IOException {
    String data = System.getProperty("hdispatch.data", "");
    assumeTrue(!data.isBlank(), "hdispatch.data is not set: the published images are not tested");
    Path home = Path.of(data, rock);
    Path stack = folder.resolve(rock + ".tif");
    try (InputStream zip = Files.newInputStream(home.resolve(rock + "_original_tif.zip"));
        ZipInputStream entries = new ZipInputStream(zip)) {
      entries.getNextEntry();
      Files.copy(entries, stack);
    }
    ImageFile image = TiffImages.open(stack);
    assertEquals(VoxelBox.whole(n, n, n), image.whole());
    byte[] labels = image.read(image.whole()).toLabels();
    VoxelImage raw = RawImages.read(home.resolve(rock + "_" + n + ".raw.gz"), n, n, n);
    for (int i = 0; i < labels.length; i++) {
      labels[i] = (byte) (labels[i] == 0 ? 1 : 0); // theirs: 0 = pore, 255 = grain
    }
    assertArrayEquals(raw.toLabels(), labels);
    VoxelBox box = new VoxelBox(n / 3, n / 4, n / 2, 64, 50, 40);
    byte[] part = image.read(box).toLabels();
    byte[] crop = raw.crop(box).toLabels();
    for (int i = 0; i < part.length; i++) {
      assertEquals(crop[i], part[i] == 0 ? 1 : 0);
    }
  }
}
