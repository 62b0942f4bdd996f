/**
 * From a block of an image to its row: what is computed of a block, by which method and settings,
 * and what its row says of it.
 *
 * <pre>{@code
 * ImageFile image = Hdf5Images.open(Path.of("core.h5"), Optional.empty());
 * BlockStudy study = new BlockStudy(image, "core.h5", BlockSettings.of(2.8e-6), HeapLimit.ofThisProcess());
 * SurveyJob job = new SurveyJob(0, 0, new VoxelBox(0, 0, 0, 200, 200, 200), Axis.Z);
 * try (Dispatcher dispatcher = Dispatcher.withWorkers(8)) {
 *   SurveyRow row = study.run(dispatcher, job, FlowListener.NONE).row();
 * }
 * }</pre>
 *
 * <p>Settings, jobs and rows are {@link java.io.Serializable}: a job may be done in another process
 * that has the image, and its row is the same.
 */
package org.hdispatch.porous.block;
