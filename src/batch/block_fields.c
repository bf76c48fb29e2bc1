// SPDX-License-Identifier: MIT
// block_fields.c -- writes the fields of the templates of a block.
//
// The fields of a template are adjacent in the pool, and the bay of a world names them. Where a field is depends on the
// world, if a body carries it, so each live bay has spots for as many fields as the template with the most fields has.
#include "batch/block_fields.h"
#include "platform/error.h"
#include "step/reserve.h"

// Returns the number of spots of a bay, so that the boxes of a world begin at a whole block, or group of blocks.
static int spots(int fields)
{
	int unit = fields > FIELD_FEW ? ARITY * ARITY : ARITY;
	return (fields + unit - 1) / unit * unit;
}

// Returns whether worlds of the block have fields of a template.
static bool has_fields(const Block* block, int t)
{
	return block->spare_of[t] >= 0 && block->templates[t].count[POOL_field] > 0;
}

static void note_fields(StepRequest* request, const Template* from)
{
	for (int k = 0; k < from->count[POOL_field]; ++k)
	{
		request->field_shapes |= from->image.field[k].kind >= FIELD_WIND;
		request->carried_fields |= from->image.field[k].body >= 0;
	}
}

scree_status block_fields(Block* block)
{
	Backend* b = block->backend;
	int most = 0, end = 0;
	for (int t = 0; t < block->template_count; ++t)
	{
		const Template* from = block->templates + t;
		if (!has_fields(block, t))
			continue;
		note_fields(&block->request, from);
		most = from->count[POOL_field] > most ? from->count[POOL_field] : most;
		end = from->first_field + from->count[POOL_field];
	}
	if (most == 0)
		return SCREE_OK;
	most = spots(most);
	if (most > INT32_MAX / 4 / block->worlds)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%d worlds of %d fields have too many fields", block->worlds, most);
	block->request.fields = most;
	TRY(pipeline_reserve(&block->pipeline, PER_FIELD, end));
	TRY(pipeline_reserve(&block->pipeline, PER_FIELD_SPOT, most * block->worlds));
	for (int t = 0; t < block->template_count; ++t)
		if (has_fields(block, t))
			TRY(b->f->write(b, POOL_field, block->templates[t].first_field, block->templates[t].count[POOL_field],
			                block->templates[t].image.field));
	return SCREE_OK;
}
