// SPDX-License-Identifier: MIT
// paint_tables.h -- tables of what colors bodies besides their attributes: velocities, graph colors, forces, starting places.
#ifndef PAINT_TABLES_H
#define PAINT_TABLES_H
#include "view/render_tables.h"

// Reads the velocities of all bodies into their table.
scree_status paint_tables_fill_velocities(RenderTables* tables);

// Fills the table of graph colors with the highest color of each body's contacts; hubs have none. False when memory is short.
bool paint_tables_fill_graph(RenderTables* tables, const scree_contact* contacts, int count);

// Fills the table of shares with the square roots of the forces of each body's contacts, as shares of RenderTables.force_range, which
// it chooses. substep: s. False when memory is short.
bool paint_tables_fill_forces(RenderTables* tables, const scree_contact* contacts, int count, float substep);

// Fills the table of shares with where the bodies began.
scree_status paint_tables_fill_starts(RenderTables* tables);

#endif
