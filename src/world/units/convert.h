// SPDX-License-Identifier: MIT
// convert.h -- converts the arguments and the results of a call between a world's unit of length and metres.
//
// A world works in metres. In a world with scree_world_def.length_unit, a public function converts its arguments, calls its
// metric_ function, which works in metres, and converts the results. A call that the library makes for itself is in metres: it
// calls api_ or metric_ functions.
#ifndef CONVERT_H
#define CONVERT_H
#include "world/units/convert_draw.h"
#include "world/units/scale.h"
#include "world/world.h"

#define CONVERTED_BYTES 1024 // arguments of calls with one item need no memory beyond this

typedef struct // a call in progress
{
	const scree_world* world;
	double unit; // units of the world per metre
	UnitCallId call;
	void* given[MOST_UNIT_ARGUMENTS];  // memory of the caller for a result that is also an argument; null for others
	void* before[MOST_UNIT_ARGUMENTS]; // its values in metres before the call
	void* blocks[2 * MOST_UNIT_ARGUMENTS];
	int block_count;
	UnitPen pen; // used by scree_world_draw
	size_t used;
	_Alignas(16) char local[CONVERTED_BYTES];
} Conversion;

// Whether calls of a world are converted. A length_unit of 1 is kept as 0.
#define HAS_UNIT(world) ((world) && (world)->def.length_unit != 0.0f)

// Converts arguments to metres. values: the address of each argument; a pointer is replaced by one to a converted copy. A
// null pointer, a wrong count and a definition of unknown size stay, because the call refuses them. Fails with
// SCREE_ERROR_OUT_OF_MEMORY.
scree_status units_in(Conversion* c, const scree_world* world, UnitCallId call, void* const* values);

// Converts the results of a successful call, releases the memory of units_in, and returns `status`. After a failure, adds the
// unit of lengths to the message.
scree_status units_out(Conversion* c, void* const* values, scree_status status);

// Converts the gravity of a definition of a world to metres.
void units_of_definition(scree_world_def* def);

// Defines converted_NAME, which calls `inner` in metres. CONVERTED: with a world before the arguments; CONVERTED_PLAIN: with the world
// among them.
#define CONVERTED_BY(inner, name, parameters, arguments, ...)       \
	static scree_status converted_##name parameters                 \
	{                                                               \
		if (!HAS_UNIT(world))                                       \
			return inner arguments;                                 \
		void* const addresses[] = {EACH(AS_ADDRESS, __VA_ARGS__)};  \
		Conversion conversion;                                      \
		TRY(units_in(&conversion, world, UNITS_##name, addresses)); \
		return units_out(&conversion, addresses, inner arguments);  \
	}
#define CONVERTED(inner, name, ...)                                                   \
	CONVERTED_BY(inner, name, (scree_world * world, EACH(AS_PARAMETER, __VA_ARGS__)), \
	             (world, EACH(AS_NAME, __VA_ARGS__)), __VA_ARGS__)
#define CONVERTED_PLAIN(name, ...) \
	CONVERTED_BY(api_##name, name, (EACH(AS_PARAMETER, __VA_ARGS__)), (EACH(AS_NAME, __VA_ARGS__)), __VA_ARGS__)

#endif
