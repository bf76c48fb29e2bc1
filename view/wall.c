// SPDX-License-Identifier: MIT
// wall.c -- a wall of worlds: copies of the scene in one batch, with different inputs, drawn side by side.
//
// Channels write the inputs and read the poses of the bodies. Every world has the shapes of the template, so its render
// rows are those of the template at other poses, moved to its tile.
#include "view/wall.h"
#include "scene/between_steps.h"
#include "view/shader.h"
#include <math.h>
#include <scree/scree_math.h>
#include <stdlib.h>
#include <string.h>

#define SPACING 1.04f // distance of tiles, in widths or heights of a tile
#define ASPECT  1.6f  // width of a wall divided by its height
#define POSE    4     // columns of a pose

static bool short_of_memory(char* sentence)
{
	snprintf(sentence, SENTENCE, "out of memory for the wall of worlds");
	return false;
}

static bool failed(char* sentence)
{
	snprintf(sentence, SENTENCE, "%s", scree_error());
	return false;
}

static bool bind_outputs(Wall* wall, const scree_body* bodies, int count, char* sentence)
{
	scree_channel* list = malloc(((size_t)count + 1) * sizeof *list);
	if (!list)
		return short_of_memory(sentence);
	for (int k = 0; k < count; ++k)
	{
		list[k] = scree_channel_make(SCREE_OUTPUT_POSE);
		list[k].body = bodies[k];
	}
	scree_status status = scree_batch_bind(wall->batch, SCREE_OUTPUTS, list, count, NULL);
	free(list);
	return status == SCREE_OK || failed(sentence);
}

// Sets Wall.body_of, and the places and centers of the rows in the frames of their bodies.
static bool place_rows(Wall* wall, scree_world* world, const scree_body* bodies, int count, char* sentence)
{
	scree_pose* poses = malloc(((size_t)count + 1) * sizeof *poses);
	if (!poses)
		return short_of_memory(sentence);
	scree_status status = scree_bodies_get_poses(world, bodies, poses, count);
	for (int k = 0; k < wall->row_count; ++k)
	{
		const scree_render_row* row = wall->rows + k;
		int body = 0;
		while (body < count && (int)bodies[body].index != row->body)
			++body;
		wall->body_of[k] = body < count ? body : -1;
		wall->places[k] = body < count ? scree_pose_multiply(scree_pose_invert(poses[body]), row->pose) : row->pose;
		wall->centers[k] = body < count ? scree_rot_apply_inverse(poses[body].rotation, row->center) : row->center;
	}
	free(poses);
	return status == SCREE_OK || failed(sentence);
}

static bool read_rows(Wall* wall, scree_world* world, char* sentence)
{
	scree_status status = scree_world_get_render_rows(world, NULL, 0, &wall->row_count);
	size_t count = (size_t)wall->row_count + 1;
	wall->rows = malloc(count * (size_t)(wall->worlds + 1) * sizeof *wall->rows);
	wall->places = malloc(count * sizeof *wall->places);
	wall->centers = malloc(count * sizeof *wall->centers);
	wall->body_of = malloc(count * sizeof *wall->body_of);
	if (!wall->rows || !wall->places || !wall->centers || !wall->body_of)
		return short_of_memory(sentence);
	if (status == SCREE_OK)
		status = scree_world_get_render_rows(world, wall->rows, wall->row_count, &wall->row_count);
	return status == SCREE_OK || failed(sentence);
}

// Returns the way from the template to the tile of a world.
static scree_vec way_to(const Wall* wall, int world)
{
	float wide = wall->boxes[0].upper.x - wall->boxes[0].lower.x,
	      high = wall->boxes[0].upper.y - wall->boxes[0].lower.y;
	return (scree_vec){SPACING * wide * (float)(world % wall->columns),
	                   -SPACING * high * (float)(world / wall->columns)};
}

void wall_place(Wall* wall, scree_box view)
{
	const float wide = view.upper.x - view.lower.x, high = view.upper.y - view.lower.y;
	const float columns = roundf(sqrtf((float)wall->worlds * ASPECT * high / fmaxf(wide, 1.0e-6f)));
	wall->columns = (int)fminf(fmaxf(columns, 1.0f), (float)wall->worlds);
	wall->boxes[0] = wall->box = view;
	for (int k = 1; k < wall->worlds; ++k)
	{
		scree_vec way = way_to(wall, k);
		scree_box box = {scree_vec_add(view.lower, way), scree_vec_add(view.upper, way)};
		wall->boxes[k] = box;
		wall->box.upper.x = fmaxf(wall->box.upper.x, box.upper.x);
		wall->box.lower.y = fminf(wall->box.lower.y, box.lower.y);
	}
}

// Binds all channels, and lists the rows of a world.
static bool read_template(Wall* wall, scree_world* world, char* sentence)
{
	int count = 0;
	scree_status status = scree_world_get_bodies(world, NULL, 0, &count);
	scree_body* bodies = malloc(((size_t)count + 1) * sizeof *bodies);
	if (!bodies)
		return short_of_memory(sentence);
	if (status == SCREE_OK)
		status = scree_world_get_bodies(world, bodies, count, &count);
	bool good = (status == SCREE_OK || failed(sentence)) &&
	            wall_inputs_bind(&wall->inputs, wall->batch, world, bodies, count, sentence) &&
	            bind_outputs(wall, bodies, count, sentence) && read_rows(wall, world, sentence) &&
	            place_rows(wall, world, bodies, count, sentence);
	free(bodies);
	return good;
}

bool wall_open(Wall* wall, const Scene* scene, scree_world* world, const scree_batch_def* wanted, char* sentence)
{
	const char* has = scene_between_steps(scene);
	const int worlds = wanted->worlds;
	*wall = (Wall){.scene = scene, .worlds = worlds};
	if (has)
		snprintf(sentence, SENTENCE, "%.100s has %s, which the worlds of a batch cannot have", scene->name, has);
	else if (worlds > WALL_MOST)
		snprintf(sentence, SENTENCE, "--worlds %d: must be at most %d", worlds, WALL_MOST);
	if (has || worlds > WALL_MOST)
		return false;
	wall->boxes = malloc((size_t)worlds * sizeof *wall->boxes);
	wall->counters = malloc((size_t)worlds * sizeof *wall->counters);
	if (!wall->boxes || !wall->counters)
		return short_of_memory(sentence);
	scree_batch_def def = *wanted;
	def.templates = &world;
	def.template_count = 1;
	if (scree_batch_create(&def, &wall->batch) != SCREE_OK)
		return failed(sentence);
	return read_template(wall, world, sentence) && (scree_batch_observe(wall->batch) == SCREE_OK || failed(sentence));
}

void wall_close(Wall* wall)
{
	scree_batch_destroy(wall->batch);
	wall_inputs_close(&wall->inputs);
	free(wall->places);
	free(wall->centers);
	free(wall->body_of);
	free(wall->rows);
	free(wall->boxes);
	free(wall->counters);
	*wall = (Wall){0};
}

scree_status wall_count(Wall* wall, scree_counters* counters)
{
	scree_status status = scree_batch_get_counters(wall->batch, wall->counters);
	counters->steps = wall->steps;
	counters->contacts = counters->touching = 0;
	counters->penetration = counters->joint_gap = 0.0f;
	for (int k = 0; k < wall->worlds && status == SCREE_OK; ++k)
	{
		const scree_batch_counters* of = wall->counters + k;
		counters->contacts += of->contacts;
		counters->touching += of->touching;
		counters->penetration = fmaxf(counters->penetration, of->penetration);
		counters->joint_gap = fmaxf(counters->joint_gap, of->joint_gap);
	}
	return status;
}

scree_status wall_step(Wall* wall, scree_counters* counters)
{
	wall_inputs_draw(&wall->inputs, wall->batch, wall->steps, wall->scene->dt);
	scree_status status = scree_batch_step(wall->batch, wall->scene->dt, wall->scene->substeps, 1);
	wall->steps += status == SCREE_OK;
	return status == SCREE_OK ? wall_count(wall, counters) : status;
}

int wall_stopped(const Wall* wall)
{
	for (int k = 0; k < wall->worlds; ++k)
		if (wall->counters[k].crowded > 0)
			return k;
	return -1;
}

scree_status wall_restart(Wall* wall, scree_counters* counters)
{
	scree_status status = scree_batch_reset(wall->batch, NULL);
	if (status == SCREE_OK)
		status = scree_batch_observe(wall->batch);
	wall->steps = 0;
	return status == SCREE_OK ? wall_count(wall, counters) : status;
}

scree_status wall_show(Wall* wall, Share* share)
{
	const float* poses = scree_batch_get_rows(wall->batch, SCREE_OUTPUTS);
	int columns = scree_batch_get_columns(wall->batch, SCREE_OUTPUTS);
	scree_render_row *out = wall->rows + wall->row_count, *all = out;
	for (int world = 0; world < wall->worlds; ++world)
	{
		scree_vec way = way_to(wall, world);
		for (int k = 0; k < wall->row_count; ++k, ++out)
		{
			*out = wall->rows[k];
			if (wall->body_of[k] >= 0)
			{
				const float* at = poses + (size_t)world * (size_t)columns + (size_t)(POSE * wall->body_of[k]);
				scree_pose pose = {{at[0], at[1]}, {at[2], at[3]}};
				out->pose = scree_pose_multiply(pose, wall->places[k]);
				out->center = scree_rot_apply(pose.rotation, wall->centers[k]);
			}
			out->pose.position = scree_vec_add(out->pose.position, way);
		}
	}
	return share_put(share, all, wall->row_count * wall->worlds);
}

scree_status wall_hash(const Wall* wall, uint64_t* hash)
{
	uint64_t* hashes = malloc((size_t)wall->worlds * sizeof *hashes);
	scree_status status = hashes ? scree_batch_get_hashes(wall->batch, hashes) : SCREE_ERROR_OUT_OF_MEMORY;
	if (status == SCREE_OK)
		*hash = hashes[0];
	free(hashes);
	return status;
}

bool wall_paints(Paint paint) { return paint == PAINT_KIND || paint == PAINT_ORIGIN || paint == PAINT_TYPE; }
