package org.hdispatch.porous.survey;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.hdispatch.porous.io.CsvLine;
import org.hdispatch.porous.io.ImageFileException;

/**
 * The files of a survey, or of one shard of it, in their folder: settings, rows, and times.
 *
 * <pre>
 * survey.properties   survey-2-of-4.properties   what the rows depend on; held while writing
 * survey.csv          survey-2-of-4.csv          a row for each job that is done
 * survey-times.csv    survey-2-of-4-times.csv    what it took: depends on the machine
 * survey-tensor.csv   survey-2-of-4-tensor.csv   the tensors of blocks that have all three axes
 * </pre>
 *
 * <p>Rows are added as jobs are done, and sorted in the end. So the finished table is the same,
 * byte by byte, however often the process was killed and begun again, and however many shards there
 * were.
 */
public final class SurveyFiles implements AutoCloseable {
  private static final Pattern SETTINGS =
      Pattern.compile("survey(-(\\d{1,9})-of-(\\d{1,9}))?\\.properties");

  private final Path folder;
  private final Shard shard;
  private final SurveySettings settings;
  private final SettingsFile held;
  private final RowFile table;
  private final RowFile times;
  private final TreeMap<Integer, SurveyStatus> status = new TreeMap<>();

  private SurveyFiles(
      Path folder,
      Shard shard,
      SurveySettings settings,
      SettingsFile held,
      RowFile table,
      RowFile times)
      throws ImageFileException {
    this.folder = folder;
    this.shard = shard;
    this.settings = settings;
    this.held = held;
    this.table = table;
    this.times = times;
    each(table, file(), row -> status.put(row.job().number(), row.status()));
  }

  /**
   * Opens the files to begin a survey or to go on with it.
   *
   * @param folder their folder, which must exist
   * @param shard which part of the survey
   * @param settings what the rows depend on
   * @param figures columns of {@link SurveyRow#figures()}
   * @param times columns of times, the first being that of the job
   * @throws ImageFileException if a file cannot be read or written, is not what it should be, there
   *     are rows without settings, or another process writes to it
   * @throws IllegalArgumentException if the folder holds a survey with other settings
   */
  public static SurveyFiles open(
      Path folder, Shard shard, SurveySettings settings, List<String> figures, List<String> times)
      throws ImageFileException {
    Path file = folder.resolve(shard.fileName() + ".properties");
    SettingsFile held = SettingsFile.hold(file);
    try {
      Optional<SurveySettings> known = held.read();
      if (known.isPresent()) {
        requireSame(settings, known.get(), file);
      }
      for (Path other : settingsFiles(folder)) {
        if (!other.equals(file)) {
          Optional<SurveySettings> there = SettingsFile.readOther(other);
          if (there.isPresent()) {
            requireSame(settings, there.get(), other);
          }
        }
      }
      if (known.isEmpty()) {
        requireNoRows(folder.resolve(shard.fileName() + ".csv"), SurveyRow.columns(figures));
        held.write(settings);
      }
      return new SurveyFiles(
          folder,
          shard,
          settings,
          held,
          RowFile.open(folder.resolve(shard.fileName() + ".csv"), SurveyRow.columns(figures)),
          RowFile.open(folder.resolve(shard.fileName() + "-times.csv"), times));
    } catch (ImageFileException | RuntimeException e) {
      held.close();
      throw e;
    }
  }

  /** Rows of unknown settings may be of another image, or of another flow. */
  private static void requireNoRows(Path file, List<String> columns) throws ImageFileException {
    if (!RowFile.read(file, columns).lines().isEmpty()) {
      throw new ImageFileException("rows must have their settings beside them: file=" + file);
    }
  }

  private static void requireSame(SurveySettings here, SurveySettings there, Path file) {
    Optional<String> difference = here.difference(there);
    if (difference.isPresent()) {
      throw new IllegalArgumentException(
          "settings must be those of the survey in this folder (else give another --output): "
              + difference.get()
              + ", file="
              + file);
    }
  }

  /** The settings of a survey and its shards, in the order of their names. */
  private static List<Path> settingsFiles(Path folder) throws ImageFileException {
    try (Stream<Path> all = Files.list(folder)) {
      return all.filter(file -> SETTINGS.matcher(file.getFileName().toString()).matches())
          .sorted()
          .toList();
    } catch (IOException e) {
      throw new ImageFileException("folder must be readable: folder=" + folder, e);
    }
  }

  /**
   * Joins the rows of all shards in a folder, as far as they are there, into one table and opens
   * it.
   *
   * @param folder the folder of the shards
   * @param figures columns of {@link SurveyRow#figures()}
   * @param times columns of times, the first being that of the job
   * @throws ImageFileException if there is no shard, the shards differ in their settings or in the
   *     row of a job, a file cannot be read or written, or another process writes the joined table
   */
  public static SurveyFiles collect(Path folder, List<String> figures, List<String> times)
      throws ImageFileException {
    if (!Files.isDirectory(folder)) {
      throw new ImageFileException("folder must exist: folder=" + folder);
    }
    List<Shard> found = new ArrayList<>();
    Optional<SurveySettings> settings = Optional.empty();
    for (Path file : settingsFiles(folder)) {
      Matcher name = SETTINGS.matcher(file.getFileName().toString());
      if (name.matches() && name.group(1) != null) {
        Optional<SurveySettings> known = SettingsFile.readOther(file);
        if (known.isPresent()) {
          found.add(new Shard(Integer.parseInt(name.group(2)), Integer.parseInt(name.group(3))));
          settings = settings.or(() -> known);
        }
      }
    }
    if (settings.isEmpty()) {
      throw new ImageFileException(
          "folder must hold shards of a survey (survey-1-of-N.properties): folder=" + folder);
    }
    SurveyFiles joined;
    try {
      joined = open(folder, Shard.WHOLE, settings.get(), figures, times);
    } catch (IllegalArgumentException e) {
      throw new ImageFileException(e.getMessage(), e);
    }
    try {
      for (Shard each : found) {
        joined.join(each);
      }
      joined.sort();
      return joined;
    } catch (ImageFileException | RuntimeException e) {
      joined.close();
      throw e;
    }
  }

  private void join(Shard part) throws ImageFileException {
    Path file = folder.resolve(part.fileName() + ".csv");
    RowFile more = RowFile.read(file, table.columns());
    List<Integer> unlike = new ArrayList<>();
    each(
        more,
        file,
        row -> {
          int job = row.job().number();
          String line = more.lines().get(job);
          if (!isDone(job)) {
            table.take(job, line);
            status.put(job, row.status());
          } else if (row.status() != SurveyStatus.FAILED && !line.equals(table.lines().get(job))) {
            unlike.add(job);
          }
        });
    if (!unlike.isEmpty()) {
      throw new ImageFileException(
          "rows of one job must be the same: job=" + unlike.get(0) + ", file=" + file);
    }
    RowFile.read(folder.resolve(part.fileName() + "-times.csv"), times.columns())
        .lines()
        .forEach(times::take);
  }

  private static void each(RowFile table, Path file, Consumer<SurveyRow> listener)
      throws ImageFileException {
    try {
      for (String line : table.lines().values()) {
        listener.accept(SurveyRow.parse(table.columns(), CsvLine.parse(line)));
      }
    } catch (IllegalArgumentException e) {
      throw new ImageFileException(
          "rows must be those of a survey: file=" + file + ", cause=" + e.getMessage(), e);
    }
  }

  /** What the rows depend on. */
  public SurveySettings settings() {
    return settings;
  }

  /** Whether a job has its row, one that failed excepted. */
  public boolean isDone(int job) {
    return status.containsKey(job) && status.get(job) != SurveyStatus.FAILED;
  }

  /** The jobs that have no row, whichever shard they belong to, in rising order. */
  public List<Integer> missing() {
    List<Integer> missing = new ArrayList<>();
    for (int job = 0; job < settings.jobs(); job++) {
      if (!status.containsKey(job)) {
        missing.add(job);
      }
    }
    return missing;
  }

  /**
   * Tells all rows, in the order of their jobs, one at a time: a million of them need no more heap
   * than their lines.
   */
  public void forEachRow(Consumer<SurveyRow> listener) throws ImageFileException {
    each(table, file(), listener);
  }

  /** The table of the rows. */
  public Path file() {
    return folder.resolve(shard.fileName() + ".csv");
  }

  /** Where rows and what they come to are told to programs. */
  public Path jsonFile() {
    return folder.resolve(shard.fileName() + ".json");
  }

  /** The table of the tensors. */
  public Path tensorFile() {
    return folder.resolve(shard.fileName() + "-tensor.csv");
  }

  /** Where the tensors are told to programs. */
  public Path tensorJsonFile() {
    return folder.resolve(shard.fileName() + "-tensor.json");
  }

  /** The table of the times. */
  public Path timesFile() {
    return folder.resolve(shard.fileName() + "-times.csv");
  }

  /** The file of the settings. */
  public Path settingsFile() {
    return folder.resolve(shard.fileName() + ".properties");
  }

  /**
   * Adds a row; when this returns, it is on the disk.
   *
   * @param row what was found
   * @param took a value for each column of times
   */
  public void append(SurveyRow row, List<String> took) throws ImageFileException {
    times.append(took);
    table.append(row.format(table.columns()));
    status.put(row.job().number(), row.status());
  }

  /** Puts rows and times into the order of their jobs, each job once. */
  public void sort() throws ImageFileException {
    times.sort();
    table.sort();
  }

  /** Lets go of the files. */
  @Override
  public void close() {
    held.close();
  }
}
