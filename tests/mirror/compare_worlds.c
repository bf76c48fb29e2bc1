// SPDX-License-Identifier: MIT
// compare_worlds.c -- compares hashes and counters of the worlds of a batch with those of the same worlds alone.
#include "mirror/mirrored.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_DIFFERENCES 400
#define SHOWN            6 // differences in the sentence of a fault

uint64_t world_hash(scree_world* world)
{
	uint64_t hash;
	must(scree_world_get_hash(world, &hash));
	return hash;
}

bool same_number(float a, float b) { return a == b || (a != a && b != b); }

// Writes the columns of the snapshots of two worlds that differ.
static void describe(scree_world* in_batch, scree_world* alone, char* text, size_t size)
{
	const void *a, *b;
	size_t a_bytes, b_bytes;
	scree_difference* found = calloc(MOST_DIFFERENCES, sizeof *found);
	int count = 0, shown = 0;
	if (scree_world_snapshot(in_batch, &a, &a_bytes) != SCREE_OK ||
	    scree_world_snapshot(alone, &b, &b_bytes) != SCREE_OK ||
	    scree_snapshots_compare(a, a_bytes, b, b_bytes, found, MOST_DIFFERENCES, &count) != SCREE_OK)
		snprintf(text, size, "; no snapshot");
	for (int k = 0; k < count && k < MOST_DIFFERENCES && shown < SHOWN; ++k)
	{
		const scree_difference* d = found + k;
		// numbers of steps, counts and lists are those of the block that the world was taken out of
		if (strstr(d->column, "counters") || strstr(d->column, "pipeline.") || strstr(d->column, "world.reports") ||
		    strstr(d->column, "world_shape"))
			continue;
		size_t length = strlen(text);
		snprintf(text + length, size - length, "; %s %s of %d items, first %d: %" PRIx64 ", alone %" PRIx64, d->column,
		         d->word, d->items, d->item, d->value_a, d->value_b);
		++shown;
	}
	free(found);
}

static bool differs(Mirror* m, int k, uint64_t hash, uint64_t alone)
{
	char text[1024] = "";
	scree_world* taken;
	if (scree_batch_extract(m->batch, k, NULL, &taken) == SCREE_OK)
	{
		describe(taken, m->alone[k], text, sizeof text);
		scree_world_destroy(taken);
	}
	return fault(m, "world %d of template %d%s has hash %016" PRIx64 ", alone %016" PRIx64 "%s", k, m->template_of[k],
	             m->paused[k] ? ", paused," : "", hash, alone, text);
}

bool compare_worlds(Mirror* m)
{
	uint64_t hashes[MOST_WORLDS];
	NEED(m, scree_batch_get_hashes(m->batch, hashes));
	for (int k = 0; k < m->worlds; ++k)
	{
		uint64_t alone = world_hash(m->alone[k]);
		m->counts->compared += 1;
		m->counts->hash += alone;
		if (hashes[k] != alone)
			return differs(m, k, hashes[k], alone);
	}
	return true;
}

static bool counters_differ(Mirror* m, int k, const char* what, double in_batch, double alone)
{
	return fault(m, "world %d of template %d has %.9g %s, alone %.9g", k, m->template_of[k], in_batch, what, alone);
}

bool compare_counters(Mirror* m)
{
	scree_batch_counters counters[MOST_WORLDS];
	NEED(m, scree_batch_get_counters(m->batch, counters));
	for (int k = 0; k < m->worlds; ++k)
	{
		scree_counters alone;
		must(scree_world_get_counters(m->alone[k], &alone));
		if (counters[k].crowded > 0) // those of the step that was abandoned
			continue;
#define SAME(member, what)                                            \
	if (!same_number((float)counters[k].member, (float)alone.member)) \
	return counters_differ(m, k, what, (double)counters[k].member, (double)alone.member)
		SAME(contacts, "contacts");
		SAME(touching, "contacts that touch");
		SAME(frozen_bodies, "frozen bodies");
		SAME(asleep_bodies, "bodies asleep");
		SAME(penetration, "m of overlap");
		SAME(joint_gap, "m of gap of a joint");
#undef SAME
		m->counts->frozen += m->paused[k] ? 0 : alone.frozen_bodies;
	}
	return true;
}
