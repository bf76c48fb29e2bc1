// SPDX-License-Identifier: MIT
// compare_bits.c -- compares the bits of a device with those of the CPU, as some drivers misreport their arithmetic. In
// a small world, bodies of all shapes fall, bounce, slide and roll on the device and on the CPU. Contracted products,
// other rounding of divisions and flushed denormals change the hash of this world.
#include "api/world/compare_bits.h"
#include "platform/error.h"
#include "world/create.h"
#include "world/world.h"

#define SIDE  7  // the sample world has SIDE * SIDE dynamic bodies and a floor
#define STEPS 32 // after these steps the lowest bodies have landed

static scree_status sample_attributes(scree_world* world, scree_attribute attributes[4])
{
	const scree_vec corners[3] = {{-0.4f, -0.3f}, {0.45f, -0.3f}, {0.0f, 0.4f}};
	scree_shape shapes[4];
	TRY(scree_shape_make_box(0.4f, 0.3f, &shapes[0]));
	TRY(scree_shape_make_circle((scree_vec){0.0f, 0.0f}, 0.35f, &shapes[1]));
	TRY(scree_shape_make_capsule((scree_vec){-0.2f, 0.0f}, (scree_vec){0.2f, 0.05f}, 0.2f, &shapes[2]));
	TRY(scree_shape_make_polygon(corners, 3, 0.05f, &shapes[3]));
	for (int k = 0; k < 4; ++k)
	{
		scree_attribute_def def = scree_attribute_def_default();
		def.shape = shapes[k];
		def.restitution = k == 1 ? 0.4f : 0.0f;
		def.rolling_resistance = k == 1 ? 0.1f : 0.0f;
		TRY(scree_attribute_create(world, &def, &attributes[k]));
	}
	return SCREE_OK;
}

static scree_status sample_bodies(scree_world* world)
{
	scree_attribute attributes[4];
	scree_attribute_def slab = scree_attribute_def_default();
	scree_body_def defs[SIDE * SIDE + 1];
	TRY(sample_attributes(world, attributes));
	TRY(scree_shape_make_box(12.0f, 0.5f, &slab.shape));
	for (int k = 0; k <= SIDE * SIDE; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].attribute = attributes[k % 4];
		defs[k].pose.position = (scree_vec){0.83f * (float)(k % SIDE) - 2.5f, 0.97f * (float)(k / SIDE) + 0.9f};
		defs[k].pose.rotation = scree_rot_make(0.37f * (float)k);
		defs[k].velocity.linear = (scree_vec){0.3f * (float)(k % 3), -4.0f};
	}
	scree_body_def* floor = &defs[SIDE * SIDE];
	floor->type = SCREE_BODY_STATIC;
	floor->pose = (scree_pose){{0.0f, -0.5f}, scree_rot_make(0.1f)};
	TRY(scree_attribute_create(world, &slab, &floor->attribute));
	return scree_bodies_create(world, defs, SIDE * SIDE + 1, NULL);
}

static scree_status sample_hash(scree_world* world, uint64_t* hash)
{
	TRY(sample_bodies(world));
	for (int k = 0; k < STEPS; ++k)
		TRY(scree_world_step(world, 1.0f / 60.0f, 4));
	return scree_world_get_hash(world, hash);
}

static scree_status clear(Backend* b)
{
	size_t most = 0;
	for (int pool = 0; pool < POOL_COUNT; ++pool)
	{
		size_t bytes = pool_info[pool].bytes * (size_t)b->capacity[pool_info[pool].per];
		most = bytes > most ? bytes : most;
	}
	void* zeros = scree_allocate(most);
	if (!zeros)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory to clear a device");
	scree_status status = SCREE_OK;
	for (int pool = 0; pool < POOL_COUNT && status == SCREE_OK; ++pool)
		status = b->f->write(b, (PoolId)pool, 0, b->capacity[pool_info[pool].per], zeros);
	if (status == SCREE_OK)
		status = b->f->wait(b);
	scree_release(zeros);
	return status;
}

scree_status compare_bits(Backend* b)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	scree_world *here, *there;
	uint64_t expected, hash;
	TRY(scree_world_create(&def, &here));
	scree_status status = sample_hash(here, &expected);
	scree_world_destroy(here);
	TRY(status);
	TRY(world_create(&def, b, &there));
	status = sample_hash(there, &hash);
	there->backend = NULL; // the device stays open when the world is destroyed
	scree_world_destroy(there);
	TRY(status);
	if (hash != expected)
		return fail(SCREE_ERROR_NO_DEVICE, "a small world has the hash %016llx on %s and %016llx on the CPU",
		            (unsigned long long)hash, b->name, (unsigned long long)expected);
	return clear(b);
}
