// SPDX-License-Identifier: MIT
// materials.c -- keeps the surface values of pairs of materials, the rows of the pool material_pair.
#include "world/objects/materials.h"
#include "platform/error.h"
#include "pools/hash_types.h"
#include "step/reserve.h"
#include "world/memory.h"
#include "world/pool_values.h"
#include <string.h>

static int place_of(int a, int b) { return a < b ? MATERIAL_PLACE(a, b) : MATERIAL_PLACE(b, a); }

MaterialPair material_row(const scree_world* world, int a, int b)
{
	int place = place_of(a, b);
	return place < world->pipeline.material_pairs ? world->materials.rows[place] : (MaterialPair){0};
}

bool material_changes(const scree_world* world, int a, int b, MaterialPair* row)
{
	MaterialPair old = material_row(world, a, b);
	flush_row(&row->friction, 3);
	return memcmp(&old, row, sizeof old) != 0;
}

scree_status material_set(scree_world* world, const char* function, int a, int b, MaterialPair row)
{
	Materials* m = &world->materials;
	Pipeline* pipeline = &world->pipeline;
	int high = a < b ? b : a, rows = MATERIAL_PLACE(high, high) + 1;
	if (rows > pipeline->material_pairs)
	{
		TRY(GROW(function, m->rows, m->capacity, rows));
		memset(m->rows + pipeline->material_pairs, 0, (size_t)(rows - pipeline->material_pairs) * sizeof *m->rows);
		pipeline->material_pairs = rows;
	}
	m->rows[place_of(a, b)] = row;
	m->waiting = true;
	pipeline->rules = pipeline->surfaces_changed = true;
	pipeline->has_rolling |= row.restitution != 0.0f || row.tangent_speed != 0.0f;
	pipeline->belts |= row.tangent_speed != 0.0f;
	pipeline->bounces |= row.restitution != 0.0f;
	return SCREE_OK;
}

scree_status upload_materials(scree_world* world)
{
	Materials* m = &world->materials;
	Backend* b = world->backend;
	int rows = world->pipeline.material_pairs;
	if (!m->waiting)
		return SCREE_OK;
	TRY(pipeline_reserve(&world->pipeline, PER_MATERIAL_PAIR, rows));
	TRY(b->f->write(b, POOL_material_pair, 0, rows, m->rows));
	m->waiting = false;
	return SCREE_OK;
}

uint64_t materials_hash(const scree_world* world)
{
	Word64 sum = 0;
	for (int k = 0; k < world->pipeline.material_pairs; ++k)
	{
		MaterialPair row = world->materials.rows[k];
		Float4 values = make_float4(row.friction, row.restitution, row.tangent_speed, 0.0f);
		if (row.sets)
			sum += hash_float4(hash_int(hash_begin(HASH_MATERIALS, k), row.sets), values);
	}
	return sum;
}

void materials_close(scree_world* world) { scree_release(world->materials.rows); }
