package org.hdispatch.porous.survey;

import java.io.Serializable;
import org.hdispatch.porous.image.Axis;
import org.hdispatch.porous.image.VoxelBox;

/**
 * A block and the axis along which its permeability is asked for.
 *
 * @param number its number in the plan, from 0
 * @param block number of the block
 * @param box the block, in voxels of the image
 * @param axis direction of the flow
 */
public record SurveyJob(int number, long block, VoxelBox box, Axis axis) implements Serializable {}
