// SPDX-License-Identifier: MIT
// device_switch.c -- moves the world to the next device, when the user presses a key.
#include "view/window/device_switch.h"
#include "view/window/viewer.h"
#include <string.h>

// Returns the index of the world's device in the list of devices. If the user selected "auto", returns the length of
// the list.
static int find_chosen(const Session* session)
{
	const char* chosen =
	    strcmp(session->device, "auto") == 0 ? session->device : scree_world_get_device(session->player.world);
	int k = 0;
	while (k < session->device_count && strcmp(session->devices[k].name, chosen) != 0)
		++k;
	return k;
}

// Returns true if entry k of the list of devices exists and is not the device of the world.
static bool is_elsewhere(const Session* session, int k)
{
	return k < session->device_count &&
	       strcmp(session->devices[k].name, scree_world_get_device(session->player.world)) != 0;
}

void devices_next(Viewer* v)
{
	const Session* session = &v->session;
	int choices = session->device_count + 1, chosen = find_chosen(session), others = 0;
	int next = v->next_device >= 0 ? v->next_device : (chosen + 1) % choices;
	for (int k = 0; k < session->device_count; ++k)
		others += is_elsewhere(session, k);
	if (others == 0)
	{
		char sentence[SENTENCE];
		const char* remedy = scree_opencl_hint();
		snprintf(sentence, sizeof sentence, "there is no other device than %.60s%s%.300s",
		         scree_world_get_device(session->player.world), *remedy ? ": " : "", remedy);
		viewer_show(v, sentence);
		return;
	}
	// skips choices that leave the world on its device, because the user would see no effect
	while (next == chosen || (next < session->device_count && !is_elsewhere(session, next)))
		next = (next + 1) % choices;
	viewer_move(v, next < session->device_count ? session->devices[next].name : "auto");
	v->next_device = (next + 1) % choices;
}
