// SPDX-License-Identifier: MIT
// process.c -- runs a program in a new process.
#include "process.h"
#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

int process_run(char* const* words, char* line, size_t size)
{
	int ends[2];
	if (pipe(ends) != 0)
	{
		perror("scree_peers: pipe");
		return -1;
	}
	fflush(stdout);
	pid_t child = fork();
	if (child == 0)
	{
		dup2(ends[1], STDOUT_FILENO);
		close(ends[0]);
		close(ends[1]);
		execvp(words[0], words);
		perror("scree_peers: exec");
		_exit(1);
	}
	close(ends[1]);
	line[0] = 0;
	FILE* output = fdopen(ends[0], "r");
	if (output)
	{
		if (!fgets(line, (int)size, output))
			line[0] = 0;
		fclose(output);
	}
	int status = 0;
	if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status))
	{
		fprintf(stderr, "scree_peers: %s could not be run to its end\n", words[0]);
		return -1;
	}
	return WEXITSTATUS(status);
}
