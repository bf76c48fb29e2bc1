// SPDX-License-Identifier: MIT
// visit_bits.c -- converts the visits to the sensors of a world: from the host's list, to bits, and to bays.
#include "batch/visit_bits.h"
#include "platform/error.h"
#include "world/objects/sensors.h"
#include <string.h>

static bool is_sensor(const scree_world* world, int collidable)
{
	return slots_in_use(&world->collidables, collidable) && world->host_collidables[collidable].sensor;
}

bool visits_are_plain(const scree_world* world)
{
	for (int k = 0; k < world->sensors.visit_count; ++k)
		if (!is_sensor(world, world->sensors.visits[k].sensor))
			return false;
	return true;
}

scree_status visits_read(const scree_world* world, const char* function, VisitBits* made)
{
	const Sensors* s = &world->sensors;
	int words = visit_words(world->collidables.used);
	size_t sensors = (size_t)s->alive;
	*made = (VisitBits){.collidables = world->collidables.used};
	made->sensors = scree_allocate(sizeof(int) * (sensors + 1));
	made->bits = scree_allocate(sizeof(Word) * (sensors * (size_t)words + 1));
	if (!made->sensors || !made->bits)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d sensors of a template", function, s->alive);
	for (int k = 0; k < made->collidables && made->count < s->alive; ++k)
		if (is_sensor(world, k))
			made->sensors[made->count++] = k;
	memset(made->bits, 0, sizeof(Word) * (sensors * (size_t)words + 1));
	for (int k = 0, n = 0; k < s->visit_count; ++k) // both lists are sorted by sensor
	{
		while (made->sensors[n] != s->visits[k].sensor)
			++n;
		made->bits[n * words + s->visits[k].visitor / 32] |= 1u << s->visits[k].visitor % 32;
	}
	return SCREE_OK;
}

void visits_close(VisitBits* made)
{
	scree_release(made->sensors);
	scree_release(made->bits);
	*made = (VisitBits){.count = 0};
}

int visits_of(const VisitBits* from) { return from->count * visit_words(from->collidables); }

void visits_put(const Bays* bays, const VisitBits* from, const void* bits, Word* to)
{
	int words = visit_words(bays->collidables), count = from ? from->count : 0;
	size_t bytes = from ? sizeof(Word) * (size_t)visit_words(from->collidables) : 0;
	memset(to, 0, sizeof(Word) * (size_t)visit_size(bays->sensors, bays->collidables));
	for (int k = 0; k < bays->sensors; ++k)
		to[k] = k < count ? (Word)from->sensors[k] : VISIT_NONE;
	for (int k = 0; k < count; ++k)
		memcpy(to + bays->sensors + k * words, (const char*)bits + bytes * (size_t)k, bytes);
}

void visits_take(const Bays* bays, const VisitBits* from, const Word* words, void* bits)
{
	int row = visit_words(bays->collidables);
	size_t bytes = sizeof(Word) * (size_t)visit_words(from->collidables);
	for (int k = 0; k < from->count; ++k)
		memcpy((char*)bits + bytes * (size_t)k, words + bays->sensors + k * row, bytes);
}

scree_status visits_give(scree_world* world, const VisitBits* from, const void* bits)
{
	int words = visit_words(from->collidables), count = 0, capacity = 32 * visits_of(from);
	if (capacity == 0)
		return SCREE_OK;
	Visit* visits = scree_allocate(sizeof *visits * (size_t)capacity);
	if (!visits)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for %d visits to sensors", capacity);
	for (int n = 0; n < visits_of(from); ++n)
	{
		Word word;
		memcpy(&word, (const char*)bits + sizeof word * (size_t)n, sizeof word);
		for (int visitor = n % words * 32; word; word >>= 1, ++visitor)
			if (word & 1u && visitor < from->collidables)
				visits[count++] = (Visit){.sensor = from->sensors[n / words], .visitor = visitor};
	}
	scree_status status = sensors_set(world, "scree_batch_extract", visits, count);
	scree_release(visits);
	return status;
}
