// SPDX-License-Identifier: MIT
// contacts.c -- reads the contacts and overlaps of the last step from the device.
#include "api/contact/contact_result.h"
#include "constraints/constraint_kinds.h"
#include "constraints/contact_report_points.h"
#include "platform/processor.h"
#include "step/state_readback.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/attributes.h"
#include "world/objects/handles.h"
#include "world/pool_read.h"
#include "world/record/api_calls.h"
#include "world/upload/upload.h"
#include "world/world.h"

typedef struct // pools of contacts, and the world shapes of their collidables
{
	Word* flags;
	Int2* pair;
	Int2* feature;
	LocalManifold* manifold;
	int* color;
	int* place;
	ContactRows* blocks;
	ContactRareRows* rare; // null if the world does not store details
	ContactKept* kept;     // impulses of contacts of sleeping bodies; null if no body slept in the last step
	WorldShape* placed;
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
	scree_release(rows->manifold);
	scree_release(rows->color);
	scree_release(rows->place);
	scree_release(rows->blocks);
	scree_release(rows->rare);
	scree_release(rows->kept);
	scree_release(rows->placed);
}

// Returns whether a collidable took part in the last step, still exists, and has kept its contacts since then.
static bool was_there(const scree_world* world, int collidable)
{
	return slots_in_use(&world->collidables, collidable) &&
	       world->host_collidables[collidable].born < world->pipeline.steps;
}

static bool both_were_there(const scree_world* world, Int2 pair)
{
	return was_there(world, pair.x) && was_there(world, pair.y);
}

static bool is_wanted(const scree_world* world, const Rows* rows, int k, Word detected)
{
	Word flags = rows->flags[k] & (CONTACT_TOUCHING | CONTACT_DETECTED | CONTACT_PENDING);
	return flags == (CONTACT_TOUCHING | detected) && both_were_there(world, rows->pair[k]);
}

static ContactReport contact_report_at(const scree_world* world, const Rows* rows, int k)
{
	int c = rows->place[k];
	Int2 pair = rows->pair[k];
	ContactReport row = {.pair = pair,
	                     .feature = rows->feature[k],
	                     .flags = rows->flags[k],
	                     .color = contact_report_color(rows->color[k])};
	Real a[8], b[8], manifold[16];
	gather_rows8((const float*)(rows->placed + pair.x), 0, a);
	gather_rows8((const float*)(rows->placed + pair.y), 0, b);
	gather_rows8((const float*)(rows->manifold + k), 0, manifold);
	gather_rows8((const float*)(rows->manifold + k), 1, manifold + 8);
	Attribute shapes[2];
	if (row.flags & MANIFOLD_ROLLS)
	{
		// a contact keeps the shapes of the last step until the next one, also if the user has given its collidable another
		attribute_item(world, rows->placed[pair.x].attribute, shapes);
		attribute_item(world, rows->placed[pair.y].attribute, shapes + 1);
		a[6] = bits_float(0);
		b[6] = bits_float(1);
	}
	ContactPoints at = contact_report_points(shapes, a, b, manifold, row.flags, row.feature);
	contact_report_place(&row, &at, a[0], a[1]);
	if (c >= 0)
	{
		const ContactRows* block = rows->blocks + c / MAX_LANES;
		row.impulse = make_float4(block->normal_impulse1[c % MAX_LANES], block->normal_impulse2[c % MAX_LANES],
		                          block->tangent_impulse1[c % MAX_LANES], block->tangent_impulse2[c % MAX_LANES]);
	}
	else if (row.flags & CONTACT_ASLEEP && rows->kept)
		row.impulse = make_float4(rows->kept[k].normal_impulse1, rows->kept[k].normal_impulse2,
		                          rows->kept[k].tangent_impulse1, rows->kept[k].tangent_impulse2);
	if (c >= 0 && rows->rare)
	{
		const ContactRareRows* rare = rows->rare + c / MAX_LANES;
		row.detail = make_float4(rare->total_impulse1[c % MAX_LANES], rare->total_impulse2[c % MAX_LANES],
		                         rare->approach1[c % MAX_LANES], rare->approach2[c % MAX_LANES]);
	}
	return row;
}

static scree_contact contact_at(const scree_world* world, const ContactReport* row)
{
	Int2 pair = row->pair;
	scree_contact contact = contact_result(row, world->def.contact_details);
	contact.a = collidable_handle(world, pair.x);
	contact.b = collidable_handle(world, pair.y);
	contact.body_a = owner_handle(world, pair.x);
	contact.body_b = owner_handle(world, pair.y);
	contact.user_a = world->host_collidables[pair.x].user;
	contact.user_b = world->host_collidables[pair.y].user;
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
		TRY(read_pool(world, function, POOL_contact_manifold, slots, (void**)&rows->manifold));
		TRY(read_pool(world, function, POOL_contact_color, slots, (void**)&rows->color));
		TRY(read_pool(world, function, POOL_contact_place, slots, (void**)&rows->place));
		int blocks = world->pipeline.counters.layout[CONSTRAINT_CONTACT].begin[COLORS + 1] / MAX_LANES;
		if (blocks > 0)
			TRY(read_pool(world, function, POOL_contact_rows, blocks, (void**)&rows->blocks));
		if (blocks > 0 && world->def.contact_details)
			TRY(read_pool(world, function, POOL_contact_rare_rows, blocks, (void**)&rows->rare));
		if (world->pipeline.sleeps)
			TRY(read_pool(world, function, POOL_contact_kept, slots, (void**)&rows->kept));
		TRY(read_pool(world, function, POOL_world_shape, world->collidables.used, (void**)&rows->placed));
		for (int k = 0, listed = 0; k < slots && listed < capacity; ++k)
		{
			if (!is_wanted(world, rows, k, detected))
				continue;
			ContactReport row = contact_report_at(world, rows, k);
			scree_contact contact = contact_at(world, &row);
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
	TRY(world_upload(world));
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

scree_status api_world_get_contacts_sized(scree_world* world, scree_contact* contacts, size_t size, int capacity,
                                          int* count)
{
	FLOAT_MODE_HERE;
	return get(world, "scree_world_get_contacts", "contacts", 0, contacts, size, capacity, count);
}

scree_status api_world_get_overlaps_sized(scree_world* world, scree_contact* overlaps, size_t size, int capacity,
                                          int* count)
{
	FLOAT_MODE_HERE;
	return get(world, "scree_world_get_overlaps", "overlaps", CONTACT_DETECTED, overlaps, size, capacity, count);
}

// Writes the contacts that the device gathered, except those that ended because the user changed something after the
// step. *count: number of these contacts, which may exceed `capacity`.
static scree_status list_rows(scree_world* world, const char* function, int found, scree_contact* contacts, size_t size,
                              int capacity, int* count)
{
	ContactReport* rows = world_scratch(world, (size_t)found * sizeof *rows);
	if (!rows)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d contacts", function, found);
	TRY(world_read(world, POOL_contact_report, 0, found, rows));
	int listed = 0;
	for (int k = 0; k < found; ++k)
	{
		if (!both_were_there(world, rows[k].pair))
			continue;
		if (listed < capacity)
		{
			scree_contact contact = contact_at(world, rows + k);
			write_result((char*)contacts + size * (size_t)listed, size, &contact, sizeof contact);
		}
		++listed;
	}
	*count = listed;
	return SCREE_OK;
}

scree_status api_body_get_contacts_sized(scree_world* world, scree_body body, scree_contact* contacts, size_t size,
                                         int capacity, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_body_get_contacts";
	int index = 0, found = 0;
	TRY(world_check(world, function));
	TRY(check_body(world, (ArgumentPlace){function, "body", ALONE}, "", body, &index));
	TRY(check_list(function, "contacts", contacts, capacity, count));
	TRY(world_upload(world));
	if (world->pipeline.counters.contacts > 0)
		TRY(world_note(world, pipeline_list_contacts(&world->pipeline, index, world->def.contact_details, &found)));
	if (found > 0)
		return list_rows(world, function, found, contacts, size, capacity, count);
	*count = 0;
	return SCREE_OK;
}
