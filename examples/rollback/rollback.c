// SPDX-License-Identifier: MIT
// rollback.c -- an example of rollback: a game for two peers over UDP, one on the CPU and one on a GPU. docs/manual/lockstep.md explains it.
//
// The program uses only the public interface of Scree and sockets of POSIX. rollback_game.c and rollback_rules.c are the game,
// rollback_session.c predicts and rolls back, rollback_peer.c is the loop of a peer.
#include "rollback_peer.h"
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

// Starts a process that plays as a peer and writes its report to a pipe. Returns its number, or -1 after a message.
static pid_t start_peer(const RollbackOptions* options, int player, UdpLink* link, const int* pipe_ends)
{
	fflush(stdout);
	pid_t process = fork();
	if (process < 0)
		perror("rollback: no process can be started");
	if (process != 0)
		return process;
	Report report;
	bool good = peer_run(options, player, link, &report);
	good &= write(pipe_ends[1], &report, sizeof report) == (ssize_t)sizeof report;
	fflush(stdout);
	_exit(good ? 0 : 1);
}

// Runs both peers in processes of their own, on free ports, and prints one table.
static int run_demo(const RollbackOptions* options)
{
	UdpLink links[2];
	int pipes[2][2], count = 0;
	pid_t processes[2];
	Report reports[2];
	bool good = true;
	signal(SIGINT, SIG_IGN); // a terminal sends it to the two processes as well, which end
	for (int k = 0; k < 2; ++k)
		if (!link_open(&links[k], 0, true))
			return 1;
	for (int k = 0; k < 2; ++k)
	{
		if (!link_set_other(&links[k], "127.0.0.1", link_get_port(&links[1 - k])) || pipe(pipes[k]) != 0)
			return 1;
		processes[k] = start_peer(options, k, &links[k], pipes[k]);
		close(pipes[k][1]);
	}
	for (int k = 0; k < 2; ++k)
	{
		int status;
		bool ended = processes[k] > 0 && waitpid(processes[k], &status, 0) == processes[k];
		good &= ended && status == 0;
		if (ended && WIFSIGNALED(status))
			fprintf(stderr, "rollback: peer %d ended by signal %d\n", k, WTERMSIG(status));
		if (read(pipes[k][0], &reports[count], sizeof *reports) == (ssize_t)sizeof *reports)
			++count;
	}
	report_print(reports, count);
	return good && count == 2 ? 0 : 1;
}

// Runs one peer; the other one is another process, also on another machine.
static int run_peer(const RollbackOptions* options)
{
	UdpLink link;
	Report report;
	bool local = strncmp(options->host, "127.", 4) == 0 || strcmp(options->host, "localhost") == 0;
	if (!link_open(&link, options->port + options->peer, local) ||
	    !link_set_other(&link, options->host, options->port + 1 - options->peer))
		return 1;
	bool good = peer_run(options, options->peer, &link, &report);
	report_print(&report, 1);
	link_close(&link);
	return good ? 0 : 1;
}

int main(int count, char** words)
{
	RollbackOptions options;
	setvbuf(stdout, NULL, _IOLBF, 0); // two processes may write to it
	if (!options_parse(&options, count - 1, words + 1))
		return 2;
	if (options.help)
	{
		options_print();
		return 0;
	}
	return options.demo ? run_demo(&options) : run_peer(&options);
}
