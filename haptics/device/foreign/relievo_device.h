/* SPDX-License-Identifier: BSD-3-Clause */
/* relievo_device.h - plug-ins for haptic devices, in C11 or C++.
 *
 * A plug-in is a shared library that exports one symbol, `relievo_device_entry`. relievo itself
 * never loads it: relievo-device-host, a child process, loads one plug-in and drives one device.
 *
 * Frame: right-handed, x right, y up, z towards the person; the origin is the workspace's centre.
 * Units: mm, N, mm/s, N/mm, and ns of CLOCK_MONOTONIC. Strings are UTF-8, owned by the plug-in, and
 * valid until the next call of the same function. Structures only grow at their end: `struct_size`
 * is filled in by whoever allocated one, and the other side touches no byte beyond it.
 *
 * Threads, in brackets at each function:
 *   [main]    one thread; may block
 *   [device]  one other thread, which runs from open() to close(); never together with [main]
 *   [any]     any thread, also while another call is in progress
 * No C++ exception may leave a plug-in. */
/* NOLINTBEGIN: this is C. */
#ifndef RELIEVO_DEVICE_H
#define RELIEVO_DEVICE_H
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define RELIEVO_DEVICE_ABI_MAJOR 1u /* Another major version is refused. */
#define RELIEVO_DEVICE_ABI_MINOR 0u /* A newer plug-in is fine: what both sides know is used. */

/* An unknown negative value counts as RELIEVO_INTERNAL, an unknown positive one as RELIEVO_OK. */
typedef int32_t relievo_status;
enum {
  RELIEVO_OK = 0,
  RELIEVO_NO_NEWS = 1,       /* step: the force was taken, there is no new place */
  RELIEVO_TIMEOUT = -1,      /* no answer in time; it is asked again */
  RELIEVO_DISCONNECTED = -2, /* gone; the device is closed */
  RELIEVO_PROTOCOL = -3,     /* it answers nonsense */
  RELIEVO_OVERHEATED = -4,
  RELIEVO_NOT_READY = -5,  /* homing, calibration, grip in its rest; step goes on */
  RELIEVO_FORCE_OFF = -6,  /* the device took the force away itself: brake, button, fuse */
  RELIEVO_FORBIDDEN = -7,  /* open: this account may not use it */
  RELIEVO_BUSY = -8,       /* open: another program has it */
  RELIEVO_NO_LIBRARY = -9, /* the maker's library is missing; last_error names it */
  RELIEVO_INTERNAL = -10
};

/* What the host offers; lives from init to deinit. */
typedef struct relievo_host {
  uint32_t struct_size, abi_major, abi_minor, reserved;
  void* self;
  /* [main] Goes to the terminal. level: 0 information, 1 warning, 2 error. */
  void (*log)(void* self, int32_t level, const char* text);
  /* [main] null: unknown. Version 1.0 knows none. */
  const void* (*get_extension)(void* self, const char* id);
} relievo_host;

typedef struct relievo_device_name {
  uint32_t struct_size, reserved;
  char id[64];   /* stable, of [a-z0-9._-]: kind and serial number, "omega3.1234" */
  char name[64]; /* for people */
} relievo_device_name;

enum {
  RELIEVO_HAS_VELOCITY = 1u << 0,
  /* The motors go free by themselves at most 50 ms after the last step. Without it the host keeps
   * every force below 2 N: a process that was killed can send no zero. */
  RELIEVO_HAS_OWN_WATCHDOG = 1u << 1
};
typedef struct relievo_device_limits {
  uint32_t struct_size, flags;   /* RELIEVO_HAS_... */
  double half_extent_mm[3];      /* of the reachable box */
  double max_force_n;            /* for a short time, in any direction; 0: it has no motors */
  double continuous_force_n;     /* for minutes; 0: unknown, half of the largest is used */
  double max_stiffness_n_per_mm; /* that it can show at rate_hz; 0: unknown, 0.4 is used */
  double position_step_mm;       /* one count of its encoders; 0: finer than matters */
  double force_delay_ms;         /* from step() to the motor */
  double rate_hz;                /* calls of step() per second, 500 .. 4000 */
} relievo_device_limits;

typedef struct relievo_sample {
  uint32_t struct_size;
  uint32_t buttons; /* bit 0 plus, 1 forward, 2 centre, 3 minus */
  double position_mm[3];
  double velocity_mm_s[3]; /* with RELIEVO_HAS_VELOCITY */
  int64_t time_ns;         /* when the place was measured */
  double hottest_motor;    /* 0 cold .. 1 at its limit; negative: unknown */
} relievo_sample;

typedef struct relievo_device {
  uint32_t struct_size, reserved;
  void* self;
  relievo_status (*open)(void* self); /* [main] may take 60 s; returns with motors at zero */
  void (*close)(void* self);          /* [main] zero force, then release; twice is harmless */
  relievo_status (*limits)(void* self, relievo_device_limits* out); /* [main] after open */
  /* [device] One read and one write, in either order. No allocation, no lock that a thread of lower
   * priority holds, no file, no printing. May wait for the device, for at most 5 ms. The force is
   * finite and within the limits, and holds until the next call. On failure zero force was sent.
   * `buttons` counts with NOT_READY, FORCE_OFF and OVERHEATED, too: it is 0 unless it is set. */
  relievo_status (*step)(void* self, const double force_n[3], int64_t now_ns, relievo_sample* out);
  /* [any] Zero force now, within 5 ms, also while step hangs. The next step may drive again. May
   * come at any time from create() to destroy(): before open() or during it, and after close(). */
  relievo_status (*cut_force)(void* self);
  const char* (*last_error)(void* self);                    /* [main] never null */
  const void* (*get_extension)(void* self, const char* id); /* [main] null: unknown */
} relievo_device;

typedef struct relievo_device_entry_t {
  uint32_t struct_size, abi_major, abi_minor, reserved;
  const char *name, *version, *maker, *licence; /* constants; read before init */
  relievo_status (*init)(const relievo_host* host, const char* own_path); /* [main] once */
  void (*deinit)(void);                                                   /* [main] */
  /* [main] Devices that are there; fills at most `capacity`, returns how many there are. Opens
   * none. out[0].struct_size says the size of one element; all have it. */
  uint32_t (*scan)(relievo_device_name* out, uint32_t capacity);
  relievo_device* (*create)(const char* id); /* [main] null: unknown id. Opens nothing. */
  void (*destroy)(relievo_device* device);   /* [main] it was closed before */
} relievo_device_entry_t;

#if defined(__GNUC__)
#define RELIEVO_DEVICE_EXPORT __attribute__((visibility("default")))
#else
#define RELIEVO_DEVICE_EXPORT
#endif
/* The one symbol that a plug-in exports and defines. */
extern RELIEVO_DEVICE_EXPORT const relievo_device_entry_t relievo_device_entry;

#ifdef __cplusplus
}
#endif
#endif
/* NOLINTEND */
