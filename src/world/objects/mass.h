// SPDX-License-Identifier: MIT
// mass.h -- computes the mass of a body from its collidables.
#ifndef MASS_H
#define MASS_H
#include "world/world.h"

// Bounds of masses that the user sets: inverse masses, and their products with squares of lever arms, stay finite.
#define LEAST_MASS    1e-15f // kg
#define LEAST_INERTIA 1e-20f // kg m^2
#define MOST_MASS     1e30f  // kg for masses, kg m^2 for inertias

// Returns the mass that the user set, else the sum over collidables, else 1 kg without inertia; 0 if not dynamic.
scree_mass mass_of_body(const scree_world* world, int body);

// Returns HostBody.mass with the correct inertia, even if the inertia is still pending.
scree_mass mass_now(const scree_world* world, int body);

// Return the inverse mass, 1/kg, and inverse inertia, 1/(kg m^2): 0 for the inverse of 0 and for a locked rotation. The
// inertia is first raised to at least LEAST_GYRATION (mass.c) * mass * arm^2.
float mass_inverse(const HostBody* host);
float mass_inverse_inertia(const HostBody* host);

// m: Returns HostBody.arm of a body for its present mass: the largest distance from the center of mass to an anchor of a
// joint. If the user set the mass, also includes a bound of the distance to points of solid shapes, because this mass may not
// fit them.
float mass_arm(const scree_world* world, const HostBody* host);

// Returns whether a dynamic body with this mass of its own would be heavy (Pipeline.heavy), whose inertia follows from its joints and
// shapes.
bool mass_is_heavy(const scree_world* world, int body, scree_mass mass);

// Return the row of a body in the pool continuous_body, and the command that sets this row. Both functions may lower
// Pipeline.continuous_way, and raise Pipeline.continuous_reach.
ContinuousBody continuous_row(scree_world* world, int body);
Command continuous_command(scree_world* world, int body);

// Records an anchor in a body's frame. This may raise the inertia of the body. Needs reserved memory for one command.
void mass_anchor(scree_world* world, int body, scree_vec anchor);

// Updates the inverse inertia of a dynamic body whose mass the user set, after a collidable became a sensor or solid.
// Does nothing for other bodies, or if `body` is -1. Needs reserved memory for one command.
void mass_touches(scree_world* world, int body);

// Sets the mass of a body on the host and on the device. Needs reserved memory for two commands.
void mass_set(scree_world* world, int body, scree_mass mass);

// Sets a mass that the user gave. The mass is kept, even while the body is not dynamic, until the body gets or loses a
// collidable. Needs reserved memory for two commands.
void mass_own(scree_world* world, int body, scree_mass mass);

// Discards the masses that the user set for the bodies in a list. Recomputes the mass of dynamic bodies, and records
// the ContinuousBody of all. A body may be listed several times; entries of -1 are skipped. gained: the bodies only got
// collidables. Then mass_settle computes the inertia, with a command for which edits_reserve has left memory: if each
// call did so, n collidables created one by one would need sums of n^2 / 2 terms.
void masses_update(scree_world* world, const int* bodies, int count, bool gained);

// Computes the pending inertia. Called before uploads, and before reads and commands that depend on the inertia.
void mass_settle(scree_world* world);

// Discards the sums of a body whose mass is set in another way, or which is about to be destroyed.
void mass_forget(scree_world* world, int body);

#endif
