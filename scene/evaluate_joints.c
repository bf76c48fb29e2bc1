// SPDX-License-Identifier: MIT
// evaluate_joints.c -- computes the joints of a block, as definitions of scree.h.
#include "scene/evaluate_joints.h"
#include "scene/block.h"
#include "scene/block_items.h"
#include <math.h>
#include <stdlib.h>

// Returns the frame of an anchor in a body. anchor: position in the world; axis: direction of the frame's x axis in the
// world. The computation uses doubles, so that the frames of both bodies coincide as closely as floats allow.
static scree_pose frame_at(scree_pose body, const double anchor[2], scree_rot axis)
{
	double c = body.rotation.c, s = body.rotation.s;
	double x = anchor[0] - body.position.x, y = anchor[1] - body.position.y;
	return (scree_pose){{(float)(c * x + s * y), (float)(c * y - s * x)},
	                    {(float)(c * axis.c + s * axis.s), (float)(c * axis.s - s * axis.c)}};
}

static scree_pose pose_of(const Scene* scene, const JointBlock* block, int side, int index)
{
	int bodies = block->ends[side].block;
	return bodies < 0 ? (scree_pose){{0, 0}, {1, 0}} : scene->blocks[bodies].poses[index];
}

// Returns the measure of a side of a gear or a pulley at the initial pose of its body.
static double measure(scree_pose body, scree_pose frame, const scree_joint_side* side)
{
	double c = body.rotation.c, s = body.rotation.s, fx = frame.position.x, fy = frame.position.y;
	double x = body.position.x + (c * fx - s * fy) - side->base.position.x;
	double y = body.position.y + (s * fx + c * fy) - side->base.position.y;
	double bc = side->base.rotation.c, bs = side->base.rotation.s;
	if (side->measure == SCREE_MEASURE_TRANSLATION)
		return x * bc + y * bs;
	if (side->measure == SCREE_MEASURE_DISTANCE)
		return sqrt(x * x + y * y);
	double fc = c * frame.rotation.c - s * frame.rotation.s, fs = s * frame.rotation.c + c * frame.rotation.s;
	return scree_rot_get_angle((scree_rot){(float)(bc * fc + bs * fs), (float)(bc * fs - bs * fc)});
}

static void couple(const Scene* scene, const JointBlock* block, const JointEnds* ends, scree_joint_def* def)
{
	const scree_pose frames[2] = {def->frame_a, def->frame_b};
	int indices[2] = {ends->a, ends->b};
	double measures[2];
	for (int k = 0; k < 2; ++k)
	{
		measures[k] = measure(pose_of(scene, block, k, indices[k]), frames[k], def->sides + k);
		if (!block->turned[k])
			def->sides[k].initial_angle = def->sides[k].measure == SCREE_MEASURE_ANGLE ? (float)measures[k] : 0.0f;
	}
	if (block->measured)
		def->coordinates[SCREE_ALONG].target = (float)(measures[1] + (double)def->ratio * measures[0]);
}

// Reports a computed number that is beyond the coordinates of a world, and returns false.
static bool fail_far(const Items* items, const JointBlock* block, const char* name, double number)
{
	char text[80];
	snprintf(text, sizeof text, "%s: %.9g must be at most %.9g", name, number, (double)SCREE_MAX_COORDINATE);
	return items_fail(items, block->path, text);
}

static bool place(const Items* items, const Scene* scene, const JointBlock* block, const JointEnds* ends,
                  scree_joint_def* def)
{
	double anchors[2][2];
	int indices[2] = {ends->a, ends->b};
	scree_pose* frames[2] = {&def->frame_a, &def->frame_b};
	double radians;
	scree_rot axis;
	if (!items_value(items, &block->axis, &radians))
		return false;
	format_store(&axis, 0, STORE_ROTATION, radians);
	for (int k = 0; k < 2; ++k)
	{
		scree_pose body = pose_of(scene, block, k, indices[k]);
		if (!items_value(items, &block->anchors[k][0], &anchors[k][0]) ||
		    !items_value(items, &block->anchors[k][1], &anchors[k][1]))
			return false;
		// for a joint on a path, frame A is the place of the path and has been read from the file
		if (k > 0 || block->on < 0)
			*frames[k] = frame_at(body, anchors[k], axis);
		double far = fmax(fabs((double)frames[k]->position.x), fabs((double)frames[k]->position.y));
		if (far > (double)SCREE_MAX_COORDINATE)
			return fail_far(items, block, k ? "anchor of b in its body" : "anchor of a in its body", far);
	}
	double x = anchors[1][0] - anchors[0][0], y = anchors[1][1] - anchors[0][1];
	if (block->measured && !block->coupled)
		def->coordinates[SCREE_ALONG].target = (float)sqrt(x * x + y * y);
	return true;
}

static bool ends_of(const Items* items, const JointBlock* block, JointEnds* ends)
{
	double a, b;
	if (!items_value(items, &block->ends[0].index, &a) || !items_value(items, &block->ends[1].index, &b))
		return false;
	*ends = (JointEnds){(int)a, (int)b};
	return block->ends[0].block != block->ends[1].block || ends->a != ends->b ||
	       items_fail(items, block->path, "a and b are the same body");
}

static bool joint_of(const Items* items, const Scene* scene, const JointBlock* block, const JointEnds* ends,
                     scree_joint_def* def)
{
	static const char* const names[] = {"along", "across", "angle"};
	char text[80];
	*def = block->def;
	if (!items_store(items, &block->numbers, def))
		return false;
	for (int k = 0; k < 3; ++k)
	{
		const scree_joint_coordinate* c = &def->coordinates[k];
		if (!c->limited || c->lower <= c->upper)
			continue;
		snprintf(text, sizeof text, "%s.limits: %.9g is above %.9g", names[k], c->lower, c->upper);
		return items_fail(items, block->path, text);
	}
	if (block->placed && !place(items, scene, block, ends, def))
		return false;
	if (block->coupled)
		couple(scene, block, ends, def);
	double target = fabs((double)def->coordinates[SCREE_ALONG].target);
	return target <= (double)SCREE_MAX_COORDINATE || fail_far(items, block, "along.target", target);
}

static bool flush(JointBatch* batch)
{
	bool good = batch->count == 0 || !batch->full || batch->full(batch->context, batch);
	batch->count = 0;
	return good;
}

static bool add_joint(Items* items, void* context)
{
	JointBatch* batch = context;
	if (batch->count == batch->capacity && !flush(batch))
		return false;
	int index = batch->count++;
	return ends_of(items, batch->block, &batch->ends[index]) &&
	       joint_of(items, batch->scene, batch->block, &batch->ends[index], &batch->defs[index]);
}

bool evaluate_joints(Reader* reader, const Scene* scene, const JointBlock* block,
                     bool (*full)(void* context, const void* batch), void* context)
{
	JointBatch batch = {.scene = scene, .block = block, .full = full, .context = context, .capacity = JOINT_BATCH};
	if (block->count < batch.capacity)
		batch.capacity = (int)block->count;
	if (batch.capacity == 0)
		return true;
	batch.defs = malloc((size_t)batch.capacity * sizeof *batch.defs);
	batch.ends = malloc((size_t)batch.capacity * sizeof *batch.ends);
	bool good = batch.defs && batch.ends;
	if (!good)
		reader_fail(reader, NULL, "out of memory");
	good = good && block_items_run(reader, &block->loops, add_joint, &batch) && flush(&batch);
	free(batch.defs);
	free(batch.ends);
	return good;
}
