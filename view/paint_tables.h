// SPDX-License-Identifier: MIT
// paint_tables.h -- fills tables of values that color bodies: velocities, graph colors, forces, starting places, sleep.
#ifndef PAINT_TABLES_H
#define PAINT_TABLES_H
#include "view/render_tables.h"

// Fills the table of velocities with the velocities of all bodies.
scree_status paint_tables_fill_velocities(RenderTables* tables);

// Fills the table of graph colors with the highest color of each body's contacts. A body gets the color of hub contacts
// only if it has no other contacts. Returns false if memory is short.
bool paint_tables_fill_graph(RenderTables* tables, const scree_contact* contacts, int count);

// Updates RenderTables.force_range, and fills the table of shares: for each body, the square root of (force /
// force_range). The force is the sum of the normal forces of the body's contacts. substep: duration of a substep, s.
// Returns false if memory is short.
bool paint_tables_fill_forces(RenderTables* tables, const scree_contact* contacts, int count, float substep);

// Fills the table of shares with the starting places of the bodies: x and y, each from 0 to 1.
scree_status paint_tables_fill_starts(RenderTables* tables);

// Updates RenderTables.awake, and fills the table of bodies that are asleep. If the world does not sleep, the table is
// not filled, and shaders do not read it.
scree_status paint_tables_fill_asleep(RenderTables* tables);

#endif
