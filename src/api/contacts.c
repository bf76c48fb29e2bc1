// SPDX-License-Identifier: MIT
// contacts.c -- the contacts and overlaps of the last step, back from the device.
#include "constraints/kinds.h"
#include "constraints/rolling.h"
#include "world/definition.h"
#include "world/world.h"

typedef struct // the pools of contacts, and where their collidables were
{
	Word* flags;
	Int2* pair;
	Int2* feature;
	Found* found;
	int* color;
	int* place;
	ContactRows* blocks;
	Placed* placed;
} Rows;

static scree_status read_pool(scree_world* world, const char* function, PoolId pool, int count, void** rows)
{
	*rows = scree_allocate(pool_info[pool].bytes * (size_t)count);
	if (!*rows)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d contacts", function, count);
	return world_read(world, pool, 0, count, *rows);
}

static void release(Rows* rows)
{
	scree_release(rows->flags);
	scree_release(rows->pair);
	scree_release(rows->feature);
	scree_release(rows->found);
	scree_release(rows->color);
	scree_release(rows->place);
	scree_release(rows->blocks);
	scree_release(rows->placed);
}

// Was it there in the last step, and is it still?
static bool was_there(const scree_world* world, int collidable)
{
	return slots_in_use(&world->collidables, collidable) &&
	       world->host_collidables[collidable].born < world->pipeline.steps;
}

static bool is_wanted(const scree_world* world, const Rows* rows, int k, Word detected)
{
	Word flags = rows->flags[k] & (CONTACT_TOUCHING | CONTACT_DETECTED);
	return flags == (CONTACT_TOUCHING | detected) && was_there(world, rows->pair[k].x) &&
	       was_there(world, rows->pair[k].y);
}

static scree_body body_of(const scree_world* world, int collidable)
{
	int body = world->host_collidables[collidable].body;
	return body < 0 ? SCREE_NULL_BODY : body_handle(world, body);
}

static scree_contact contact_at(const scree_world* world, const Rows* rows, int k)
{
	Int2 pair = rows->pair[k];
	Placed a = rows->placed[pair.x], b = rows->placed[pair.y];
	Word flags = rows->flags[k];
	Int feature[2] = {rows->feature[k].x, rows->feature[k].y};
	Real row_a[8], row_b[8], found[16];
	gather_rows8((const float*)rows->placed, pair.x, row_a);
	gather_rows8((const float*)rows->placed, pair.y, row_b);
	gather_rows8((const float*)rows->found, 2 * k, found);
	gather_rows8((const float*)rows->found, 2 * k + 1, found + 8);
	ContactPoints at = contact_points_held(row_a, row_b, found);
	if (flags & FOUND_ROLLS)
	{
		Attribute shapes[2];
		attribute_item(world, a.attribute, shapes);
		attribute_item(world, b.attribute, shapes + 1);
		row_a[6] = bits_float(0);
		row_b[6] = bits_float(1);
		const Advance rests = {{0.0f, 0.0f}, 0.0f};
		at = rolling_points(shapes, row_a, row_b, found, (Int)flags, feature, rests, rests);
	}
	int c = rows->place[k];
	float impulse[4] = {0.0f, 0.0f, 0.0f, 0.0f};
	if (c >= 0)
	{
		const ContactRows* block = rows->blocks + c / MAX_LANES;
		impulse[0] = block->normal_impulse1[c % MAX_LANES];
		impulse[1] = block->normal_impulse2[c % MAX_LANES];
		impulse[2] = block->tangent_impulse1[c % MAX_LANES];
		impulse[3] = block->tangent_impulse2[c % MAX_LANES];
	}
	scree_contact contact = {.a = collidable_handle(world, pair.x),
	                         .b = collidable_handle(world, pair.y),
	                         .normal = {at.normal.x, at.normal.y},
	                         .color = rows->color[k],
	                         .count = (int)(rows->flags[k] & CONTACT_COUNT),
	                         .body_a = body_of(world, pair.x),
	                         .body_b = body_of(world, pair.y),
	                         .user_a = world->host_collidables[pair.x].user,
	                         .user_b = world->host_collidables[pair.y].user};
	contact.points[0] = (scree_contact_point){{a.x + at.point[0].x, a.y + at.point[0].y},
	                                          at.separation[0],
	                                          impulse[0],
	                                          impulse[2],
	                                          (uint32_t)rows->feature[k].x};
	if (contact.count == 2)
		contact.points[1] = (scree_contact_point){{a.x + at.point[1].x, a.y + at.point[1].y},
		                                          at.separation[1],
		                                          impulse[1],
		                                          impulse[3],
		                                          (uint32_t)rows->feature[k].y};
	return contact;
}

static scree_status list(scree_world* world, const char* function, Word detected, scree_contact* contacts, size_t size,
                         int capacity, int* count, Rows* rows)
{
	int slots = world->pipeline.counters.contacts, total = 0;
	TRY(read_pool(world, function, POOL_contact_flags, slots, (void**)&rows->flags));
	TRY(read_pool(world, function, POOL_pair, slots, (void**)&rows->pair));
	for (int k = 0; k < slots; ++k)
		total += is_wanted(world, rows, k, detected);
	if (total > 0 && capacity > 0)
	{
		TRY(read_pool(world, function, POOL_contact_feature, slots, (void**)&rows->feature));
		TRY(read_pool(world, function, POOL_contact_found, slots, (void**)&rows->found));
		TRY(read_pool(world, function, POOL_contact_color, slots, (void**)&rows->color));
		TRY(read_pool(world, function, POOL_contact_place, slots, (void**)&rows->place));
		int blocks = world->pipeline.counters.layout[CONSTRAINT_CONTACT].begin[COLORS + 1] / MAX_LANES;
		if (blocks > 0)
			TRY(read_pool(world, function, POOL_contact_rows, blocks, (void**)&rows->blocks));
		TRY(read_pool(world, function, POOL_placed, world->collidables.used, (void**)&rows->placed));
		for (int k = 0, listed = 0; k < slots && listed < capacity; ++k)
		{
			if (!is_wanted(world, rows, k, detected))
				continue;
			scree_contact contact = contact_at(world, rows, k);
			write_result((char*)contacts + size * (size_t)listed++, size, &contact, sizeof contact);
		}
	}
	*count = total;
	return SCREE_OK;
}

static scree_status get(scree_world* world, const char* function, const char* argument, Word detected,
                        scree_contact* contacts, size_t size, int capacity, int* count)
{
	TRY(world_check(world, function));
	TRY(check_list(function, argument, contacts, capacity, count));
	TRY(world_flush(world));
	if (world->pipeline.counters.contacts == 0)
	{
		*count = 0;
		return SCREE_OK;
	}
	Rows rows = {0};
	scree_status status = list(world, function, detected, contacts, size, capacity, count, &rows);
	release(&rows);
	return status;
}

scree_status scree_world_get_contacts_sized(scree_world* world, scree_contact* contacts, size_t size, int capacity,
                                            int* count)
{
	return get(world, "scree_world_get_contacts", "contacts", 0, contacts, size, capacity, count);
}

scree_status scree_world_get_overlaps_sized(scree_world* world, scree_contact* overlaps, size_t size, int capacity,
                                            int* count)
{
	return get(world, "scree_world_get_overlaps", "overlaps", CONTACT_DETECTED, overlaps, size, capacity, count);
}
