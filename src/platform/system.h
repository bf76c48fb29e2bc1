// SPDX-License-Identifier: MIT
// system.h -- wraps threads, mutexes and condition variables of the operating system.
#ifndef SYSTEM_H
#define SYSTEM_H

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
typedef SRWLOCK Mutex;
typedef CONDITION_VARIABLE Condition;
typedef HANDLE Thread;
#define THREAD_RESULT         DWORD WINAPI
#define THREAD_END            0
#define MUTEX_OPEN            SRWLOCK_INIT // initializer of a static mutex
#define mutex_open            InitializeSRWLock
#define mutex_close(m)        ((void)(m))
#define mutex_lock            AcquireSRWLockExclusive
#define mutex_try(m)          (TryAcquireSRWLockExclusive(m) != 0) // locks it unless it is locked; returns whether it did
#define mutex_unlock          ReleaseSRWLockExclusive
#define condition_open        InitializeConditionVariable
#define condition_close(c)    ((void)(c))
#define condition_wait(c, m)  SleepConditionVariableSRW(c, m, INFINITE, 0)
#define condition_wake_all    WakeAllConditionVariable
#define thread_start(t, f, x) ((*(t) = CreateThread(NULL, 0, f, x, 0, NULL)) != NULL)
#define thread_join(t)        ((void)WaitForSingleObject(t, INFINITE), (void)CloseHandle(t))
#define give_core_away()      ((void)SwitchToThread())
#else
#include <pthread.h>
#include <sched.h>
typedef pthread_mutex_t Mutex;
typedef pthread_cond_t Condition;
typedef pthread_t Thread;
#define THREAD_RESULT         void*
#define THREAD_END            NULL
#define MUTEX_OPEN            PTHREAD_MUTEX_INITIALIZER // initializer of a static mutex
#define mutex_open(m)         pthread_mutex_init(m, NULL)
#define mutex_close           pthread_mutex_destroy
#define mutex_lock            pthread_mutex_lock
#define mutex_try(m)          (pthread_mutex_trylock(m) == 0) // locks it unless it is locked; returns whether it did
#define mutex_unlock          pthread_mutex_unlock
#define condition_open(c)     pthread_cond_init(c, NULL)
#define condition_close       pthread_cond_destroy
#define condition_wait        pthread_cond_wait
#define condition_wake_all    pthread_cond_broadcast
#define thread_start(t, f, x) (pthread_create(t, NULL, f, x) == 0)
#define thread_join(t)        pthread_join(t, NULL)
#define give_core_away()      sched_yield()
#endif

#endif
