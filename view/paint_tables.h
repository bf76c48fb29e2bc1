// SPDX-License-Identifier: MIT
// paint_tables.h -- tables of values that color bodies: velocities, graph colors, forces, starting places.
#ifndef PAINT_TABLES_H
#define PAINT_TABLES_H
#include "view/render_tables.h"

// Reads the velocities of all bodies into their table.
scree_status paint_tables_fill_velocities(RenderTables* tables);

// Fills the table of graph colors with the highest color of each body's contacts; contacts of hubs have no color.
// Returns false if memory is short.
bool paint_tables_fill_graph(RenderTables* tables, const scree_contact* contacts, int count);

// Fills the table of shares with the forces of each body's contacts: the square root of force /
// RenderTables.force_range, which it updates. substep is in s. Returns false if memory is short.
bool paint_tables_fill_forces(RenderTables* tables, const scree_contact* contacts, int count, float substep);

// Fills the table of shares with the starting places of the bodies.
scree_status paint_tables_fill_starts(RenderTables* tables);

#endif
