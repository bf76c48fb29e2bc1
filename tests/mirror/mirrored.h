// SPDX-License-Identifier: MIT
// mirrored.h -- drives a batch of hostile worlds by random calls, and repeats all of them on a world alone for each of its worlds.
#ifndef MIRRORED_H
#define MIRRORED_H
#include "mirror/hostile.h"

#define MOST_WORLDS    40 // maximum number of worlds of a batch
#define MOST_TEMPLATES 4
#define MOST_CHANNELS  24 // maximum number of channels of a list
#define FAN_RAYS       5  // maximum number of rays of a channel

typedef struct // sums over seeds
{
	int seeds, ended; // ended: seeds that ended early, because a batch was refused or a call has no mirror
	int batches, faults, frozen;
	int64_t steps, compared; // steps of worlds; worlds whose hashes were compared
	uint64_t hash;           // sum of all hashes of worlds alone
} Counts;

typedef struct
{
	const char* device;
	int lanes;  // 0: random
	bool shows; // prints all calls
} Setting;

typedef struct
{
	scree_world* world; // as it was when the batch was created
	Objects objects;
	scree_vec gravity;
	int origin; // index of the hostile world that it came from; worlds of one origin have the same structure
} Source;

typedef struct
{
	scree_channel channels[MOST_CHANNELS];
	int count, columns;
	float* rows; // [worlds][columns], made by the batch; null: no columns
} List;

typedef struct // a saved world
{
	char* state; // null: none
	size_t bytes;
	scree_world* world; // clone of the world alone when it was saved
	int origin;
} Bank;

typedef struct
{
	Setting setting;
	Counts* counts;
	uint64_t seed, dice;
	scree_batch* batch;
	int worlds, template_count;
	Source templates[MOST_TEMPLATES];
	scree_world* alone[MOST_WORLDS]; // the mirror of each world
	int32_t template_of[MOST_WORLDS], next_of[MOST_WORLDS];
	uint8_t paused[MOST_WORLDS]; // crowded worlds too
	scree_vec gravity[MOST_WORLDS];
	// touches of each output at the last outputs, or when it was bound or its world replaced
	float touches[MOST_WORLDS][MOST_CHANNELS];
	bool pulled;       // a call has set the gravity of the worlds
	bool varied;       // scree_batch_def.other_templates
	int contact_limit; // scree_batch_def.contact_limit; 0: none
	List lists[3];     // by scree_channels
	Bank bank;
	int call;            // number of calls so far
	char made[1024];     // description of the last call
	char sentence[2048]; // the fault; empty: none
	bool ended;          // the rest of the seed cannot be mirrored
} Mirror;

// Functions that return bool return false if the seed ends: by a fault, whose sentence is kept, or because a call has no mirror.

// mirrored.c
void mirror_run(const Setting* setting, uint64_t seed, Counts* counts); // runs a seed, and prints its fault
void note(Mirror* m, const char* format, ...) __attribute__((format(printf, 2, 3))); // begins the description of a call
bool fault(Mirror* m, const char* format, ...) __attribute__((format(printf, 2, 3))); // returns false
bool end_early(Mirror* m);                                                            // returns false
bool needed(Mirror* m, scree_status status, const char* call); // a status other than SCREE_OK is a fault

#define NEED(m, call)                    \
	do                                   \
	{                                    \
		if (!needed((m), (call), #call)) \
			return false;                \
	} while (0)

// open_batch.c
bool batch_open(Mirror* m);
bool batch_reopen(Mirror* m); // replaces the batch by one whose templates are some of its worlds
void batch_close(Mirror* m);
scree_world* clone_alone(scree_world* world);

// compare_worlds.c
uint64_t world_hash(scree_world* world);
bool same_number(float a, float b); // the same, or both no numbers
bool compare_worlds(Mirror* m);
bool compare_counters(Mirror* m);

// channels
int channel_columns_of(const scree_channel* channel); // bind_channels.c
// Returns whether a world has the objects of a channel.
bool channel_found(scree_world* world, const scree_channel* channel);
bool bind_inputs(Mirror* m);
bool bind_resets(Mirror* m);
bool bind_outputs(Mirror* m);
void fill_rows(Mirror* m, scree_channels list); // fill_rows.c
// apply_rows.c: applies inputs to a world alone. again: before a further step of a call.
bool apply_rows(Mirror* m, scree_channels list, int world, float dt, bool again);
bool check_outputs(Mirror* m);            // read_outputs.c
void touches_begin(Mirror* m, int world); // counts touches as if they were the last outputs

// calls of a batch: call_worlds.c, call_states.c, call_steps.c
void replace_alone(Mirror* m, int world, scree_world* by); // by: is owned by the mirror
bool call_templates(Mirror* m);
bool call_reset(Mirror* m);
bool call_pause(Mirror* m);
bool call_gravity(Mirror* m);
bool call_copy(Mirror* m);
bool call_bank(Mirror* m);
bool call_extract(Mirror* m);
bool call_insert(Mirror* m);
bool call_step(Mirror* m);
bool call_observe(Mirror* m);
bool refused_as_heavy(scree_status status); // a mass of the inputs is too large for a batch

#endif
