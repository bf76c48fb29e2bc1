// SPDX-License-Identifier: MIT
// save_list.c -- keeps the list of the saves of a world (save/saves.h), and gives saves up.
#include "world/save_list.h"
#include "platform/error.h"

// Returns the range of a save (below SAVES) or of a structure.
SavedRange save_range(const SaveList* list, int k)
{
	return k < SAVES ? list->saves[k].range : list->structures[k - SAVES].range;
}

void saves_measure(Saves* saves)
{
	saves->end = 0;
	for (int k = 0; k < SAVES + STRUCTURES; ++k)
	{
		SavedRange range = save_range(saves->list, k);
		saves->end = range.first + range.count > saves->end ? range.first + range.count : saves->end;
	}
}

void save_give_up(SaveList* list, Save* save)
{
	if (save->made)
		--list->structures[save->structure].uses;
	save->made = false;
}

void save_discard(scree_world* world, int number)
{
	SaveList* list = world->saves.list;
	if (!list)
		return;
	Save* save = list->saves + number;
	save_give_up(list, save);
	scree_release(save->host.bytes);
	*save = (Save){0};
	for (int k = 0; k < STRUCTURES; ++k)
		if (list->structures[k].uses == 0)
		{
			scree_release(list->structures[k].host.bytes);
			list->structures[k] = (SavedStructure){0};
		}
	saves_measure(&world->saves);
}

void saves_close(scree_world* world)
{
	for (int k = 0; k < SAVES; ++k)
		save_discard(world, k);
	scree_release(world->saves.list);
}
