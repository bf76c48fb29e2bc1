// SPDX-License-Identifier: MIT
// world.h -- what a world is made of on the host, for the files that share it.
#ifndef WORLD_H
#define WORLD_H
#include "backend/backend.h"
#include "platform/error.h"
#include "step/pipeline.h"
#include "world/auto.h"
#include "world/check.h"
#include "world/edits.h"
#include "world/slots.h"
#include "world/targets.h"

typedef struct // what only the host knows of a body
{
	scree_body_type type;
	uint32_t locks;
	float gravity_scale, linear_damping, angular_damping;
	scree_mass mass;
	int first_collidable, last_collidable; // -1 for none
	int collidables;                       // how many
	uint64_t user;
	int target;    // 1 + its place among the targets, 0 for none
	bool disabled; // takes no part: its collidables are dead to the device
	bool kept;     // the device may have something in the row kept of the slot
	Waiting waiting;
	bool marked; // within a call: named by the batch
} HostBody;

typedef struct // what only the host knows of a collidable
{
	int attribute;
	int body; // -1 for none
	scree_pose pose;
	scree_filter filter;
	uint64_t user;
	int next, previous; // of the same body, -1 for none; from here on collidable_put fills in
	int64_t born;       // steps that the world had taken
	Waiting waiting;
	bool marked;
} HostCollidable;

typedef struct // what else the host knows of an attribute
{
	uint32_t name;   // a hash of its values, never 0
	int claims;      // times that the user made it, less those that it was destroyed
	int collidables; // that have it
	bool waiting;    // for the next flush
} HostAttribute;

struct scree_world
{
	scree_world_def def;
	scree_opengl opengl; // that def.opengl points to, where there is one
	Backend* backend;
	scree_status broken;       // what befell it, after which it can only be destroyed; SCREE_OK as long as all is well
	Slots bodies, collidables; // body slot 0 is the ground: motionless, never given out
	HostBody* host_bodies;     // of each slot
	HostCollidable* host_collidables;
	int host_body_capacity, host_collidable_capacity;
	Slots attribute_slots;
	scree_attribute_def* attributes; // of each slot
	HostAttribute* host_attributes;  // the same
	int* attribute_table;            // 1 + attribute by name, 0 for none; open addressing
	int attribute_capacity, host_attribute_capacity, attribute_table_size;
	int dynamic_bodies, disabled_bodies;
	Target* targets; // of kinematic bodies, in no order
	int target_count, target_capacity;
	Edits edits;
	Pipeline pipeline;
	int shared_rows; // room in the memory that OpenGL draws from; 0 while there is none
	AutoDevice auto_device;
	char device[160]; // the name of backend
	void* scratch;    // for a call to work in
	size_t scratch_bytes;
};

// Makes a world on a device that is open. On failure, *world is null and the device still the caller's.
scree_status world_create(const scree_world_def* def, Backend* backend, scree_world** world);

// Reads items of a pool for the user.
scree_status world_read(scree_world* world, PoolId pool, int first, int count, void* items);

// src/world/upload.c: sends everything the user changed since the last call to the device. Called before a step and before
// anything is read back.
scree_status world_upload(scree_world* world);

// Refuses a world that is null or broken.
scree_status world_check(const scree_world* world, const char* function);

// Passes a status on; a device that has failed leaves a broken world.
scree_status world_note(scree_world* world, scree_status status);

// At least bytes to work in, until the next call; null when there is no memory.
void* world_scratch(scree_world* world, size_t bytes);

// An array of capacity items made larger for needed ones, by half at least.
scree_status grow(const char* function, void** array, int* capacity, size_t item, int needed);
#define GROW(function, array, capacity, needed) grow(function, (void**)&(array), &(capacity), sizeof *(array), needed)

// Handles to slots and back. A handle of nothing is SCREE_ERROR_STALE, and its sentence says where it stands.
scree_status check_body(const scree_world* world, Where at, const char* member, scree_body body, int* index);
scree_status check_collidable(const scree_world* world, Where at, scree_collidable collidable, int* index);
scree_status check_attribute(const scree_world* world, Where at, const char* member, scree_attribute attribute,
                             int* index);
scree_body body_handle(const scree_world* world, int index);
scree_collidable collidable_handle(const scree_world* world, int index);
scree_attribute attribute_handle(const scree_world* world, int index);

// src/api/attribute.c: its row in the pool attribute, and in the pool thickness
void attribute_item(const scree_world* world, int index, Attribute* item);
float attribute_thickness(const scree_world* world, int index);

// src/world/mass.c: mass from the collidables; a dynamic body without any is 1 kg that cannot turn, others have none.
scree_mass mass_of_body(const scree_world* world, int body);
float mass_inverse(const HostBody* host);
float mass_inverse_inertia(const HostBody* host);
// What the device keeps of a dynamic body for guard, and the command that tells it.
Guarded body_guarded(scree_world* world, int body); // may lower the bounds in Step of what guard looks at
Command guarded_command(scree_world* world, int body);
// The mass of a body becomes this one, also on the device. There is room for two commands.
void mass_set(scree_world* world, int body, scree_mass mass);

// src/api/setting.c
scree_status check_type(Where at, const char* member, scree_body_type type);
scree_status check_locks(Where at, const char* member, uint32_t locks);
// What is left of a velocity: nothing along what is locked, nothing at all for a static body.
scree_velocity body_velocity_allowed(const HostBody* host, scree_velocity velocity);

// src/api/collidable.c
// Room for so many more, after which putting one cannot fail. edits_reserve is the caller's.
scree_status collidables_reserve(scree_world* world, const char* function, int more);
// Takes count slots, with leaves in the trees but for KIND_DEAD. slots holds the kinds (KIND_*) and gets the slots; on
// failure none is taken.
scree_status collidables_take(scree_world* world, int* slots, int count);
// Makes a collidable in a slot, last of its body's list (body -1: none); takes one out again and frees the slot.
void collidable_put(scree_world* world, int index, const HostCollidable* made);
void collidable_remove(scree_world* world, int index);
int collidable_kind(const scree_world* world, int index); // KIND_DEAD also on a body that is disabled
int kind_on_body(const scree_world* world, int body);     // of a collidable of this body, -1 for none
int kind_of_type(scree_body_type type);
// The tree in which collidables of a kind lie.
static inline int tree_of_kind(int kind) { return kind == KIND_STATIC; }

#endif
