/* SPDX-FileCopyrightText: 2026 The Fathom authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * An exported model as a vehicle of ArduPilot's SITL, by its JSON interface: UDP on loopback.
 *
 *   fathom_export --model=rov.json --vehicle=rov.yaml --format=c --out=rov.h
 *   cc -std=c11 -O2 -DMODEL=rov -DMODEL_HEADER='"rov.h"' -I. -o rov_sitl ardupilot_sitl.c -lm
 *   ./rov_sitl --voltage=16
 *   sim_vehicle.py -v ArduSub -f vectored_6dof --model JSON:127.0.0.1
 *
 * For each frame of SITL: pulse widths to thrusts, to tau, one step of the model, and a line of
 * JSON with the motion back to the sender. Time is that of the frames. docs/export.md, "ArduPilot".
 *
 * MODEL_HEADER declares rov_state, rov_rate, rov_step, rov_thrusters, rov_thrust (every exported
 * header), rov_num_thrusters, rov_forces (with a vehicle file that has thrusters) and
 * rov_thrust_of_pulse (where they have thrust tables). What yours lacks, a header of your own adds.
 */
#define _POSIX_C_SOURCE 200809L

#if !defined(MODEL) || !defined(MODEL_HEADER)
#error "Compile with -DMODEL=rov -DMODEL_HEADER='\"rov.h\"', rov being the model's name."
#endif

#include MODEL_HEADER

#include <arpa/inet.h>
#include <errno.h>
#include <math.h>
#include <poll.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>

#define JOINED(model, name) model##_##name
#define EXPANDED(model, name) JOINED(model, name)
#define OF_MODEL(name) EXPANDED(MODEL, name)

#define GRAVITY 9.80665   /* as in ArduPilot [m/s^2] */
#define LONGEST_STEP 0.02 /* of the model; a longer frame is several [s] */
#define RESEND_AFTER 0.5  /* SITL sends a frame again a second after it got no answer [s] */
#define MOST_CHANNELS 32
#ifndef SILENCE
#define SILENCE 5 /* after which it is said that nothing comes [s] */
#endif
#define NUM_THRUSTERS OF_MODEL(num_thrusters)

typedef struct {
  int port;
  double voltage;                 /* of the thrusters' supply [V] */
  int channel[NUM_THRUSTERS];     /* of SITL, from 1, that drives each thruster */
  int is_reversed[NUM_THRUSTERS]; /* where MOT_n_DIRECTION is -1 */
} options;

typedef struct {
  unsigned rate; /* [Hz] */
  uint32_t count;
  int num_channels;
  unsigned pulse[MOST_CHANNELS]; /* [us] */
} frame;

typedef struct {
  OF_MODEL(state) state;
  OF_MODEL(thrusters) thrusters;
  double tau[6]; /* over the last step [N], [N m] */
  double time;   /* since the vehicle was set to its start [s] */
} vehicle;

/* Who is to be answered. */
typedef struct {
  struct sockaddr_in address;
  socklen_t size;
} sitl;

static void reset(vehicle* rov) {
  memset(rov, 0, sizeof *rov);
  rov->state.attitude[3] = 1.0;
}

/* The value of "--name=value", or null. */
static const char* value_of(const char* argument, const char* name) {
  const size_t length = strlen(name);
  return strncmp(argument, name, length) == 0 ? argument + length : NULL;
}

/* "1,2,-3": the channel of each thruster, below 0 if it is reversed. 0 where it is not that. */
static int read_channels(const char* text, options* opts) {
  int k;
  for (k = 0; k < NUM_THRUSTERS; ++k) {
    char* end;
    const long channel = strtol(text, &end, 10);
    if (end == text || channel == 0 || labs(channel) > MOST_CHANNELS) return 0;
    if (*end != (k + 1 < NUM_THRUSTERS ? ',' : '\0')) return 0;
    opts->channel[k] = (int)labs(channel);
    opts->is_reversed[k] = channel < 0;
    text = end + 1;
  }
  return 1;
}

static int read_options(int argc, char** argv, options* opts) {
  int i, k;
  opts->port = 9002;
  opts->voltage = 16.0;
  for (k = 0; k < NUM_THRUSTERS; ++k) {
    opts->channel[k] = k + 1;
    opts->is_reversed[k] = 0;
  }
  for (i = 1; i < argc; ++i) {
    const char *port = value_of(argv[i], "--port="), *voltage = value_of(argv[i], "--voltage=");
    const char* channels = value_of(argv[i], "--channels=");
    char* end = NULL;
    int is_good = 0;
    if (port) {
      const long number = strtol(port, &end, 10);
      is_good = end != port && *end == '\0' && number >= 0 && number <= 65535;
      opts->port = is_good ? (int)number : 0;
    } else if (voltage) {
      opts->voltage = strtod(voltage, &end);
      is_good = end != voltage && *end == '\0' && isfinite(opts->voltage) && opts->voltage > 0.0;
    } else if (channels) {
      is_good = read_channels(channels, opts);
    }
    if (!is_good) {
      fprintf(stderr,
              "ardupilot_sitl: cannot use '%s', expected --port=9002 (0: a free one), --voltage=16 "
              "or --channels=1,-2,... with a channel for each of %d thrusters, below 0 where it is "
              "reversed.\n",
              argv[i],
              (int)NUM_THRUSTERS);
      return 0;
    }
  }
  return 1;
}

/* A socket on loopback; sets the port where it was 0. Below 0 where that fails. */
static int open_socket(int* port) {
  struct sockaddr_in address;
  socklen_t size = sizeof address;
  const int fd = socket(AF_INET, SOCK_DGRAM, 0);
  if (fd < 0) return -1;
  memset(&address, 0, sizeof address);
  address.sin_family = AF_INET;
  address.sin_port = htons((uint16_t)*port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (bind(fd, (struct sockaddr*)&address, sizeof address) != 0) return -1;
  if (getsockname(fd, (struct sockaddr*)&address, &size) != 0) return -1;
  *port = ntohs(address.sin_port);
  return fd;
}

static unsigned two_bytes(const unsigned char* at) { return at[0] | (unsigned)at[1] << 8; }

/* Reads a packet: magic, rate, count, pulses, little endian. Says why it cannot, and gives 0. */
static int read_frame(const unsigned char* bytes, size_t size, frame* out) {
  const unsigned magic = size >= 2 ? two_bytes(bytes) : 0;
  int k;
  out->num_channels = magic == 18458 ? 16 : magic == 29569 ? 32 : 0;
  if (out->num_channels == 0) {
    fprintf(stderr,
            "ardupilot_sitl: ignored a packet of %zu bytes with magic %u, expected 18458 (16 "
            "channels) or 29569 (32).\n",
            size,
            magic);
    return 0;
  }
  if (size != 8u + 2u * (unsigned)out->num_channels) {
    fprintf(stderr,
            "ardupilot_sitl: ignored a packet of %zu bytes, expected %d with magic %u.\n",
            size,
            8 + 2 * out->num_channels,
            magic);
    return 0;
  }
  out->rate = two_bytes(bytes + 2);
  if (out->rate == 0) {
    fprintf(stderr, "ardupilot_sitl: ignored a packet with a frame rate of 0 Hz.\n");
    return 0;
  }
  out->count = two_bytes(bytes + 4) | (uint32_t)two_bytes(bytes + 6) << 16;
  for (k = 0; k < out->num_channels; ++k) out->pulse[k] = two_bytes(bytes + 8 + 2 * k);
  return 1;
}

/* Says which thrusters are off because packets have too few channels for them. */
static void say_missing_channels(int num_channels, const options* opts) {
  int k;
  for (k = 0; k < NUM_THRUSTERS; ++k) {
    if (opts->channel[k] <= num_channels) continue;
    fprintf(stderr,
            "ardupilot_sitl: thruster %d is off: its channel %d is not in packets of %d. "
            "SERVO_32_ENABLE = 1 gives 32.\n",
            k + 1,
            opts->channel[k],
            num_channels);
  }
}

/* tau that the pulses command. A channel that the packet has not is off. */
static void command_of(const frame* in, const options* opts, double command[6]) {
  double thrust[NUM_THRUSTERS];
  int k;
  for (k = 0; k < NUM_THRUSTERS; ++k) {
    const int channel = opts->channel[k];
    double pulse = channel <= in->num_channels ? in->pulse[channel - 1] : 0.0;
    if (opts->is_reversed[k] && pulse != 0.0) pulse = 3000.0 - pulse;
    thrust[k] = OF_MODEL(thrust_of_pulse)(k, pulse, opts->voltage);
  }
  OF_MODEL(forces)(thrust, command);
}

/* Moves the vehicle on by one frame. */
static void step(vehicle* rov, const double command[6], double duration) {
  const int num_steps = 1 + (int)(duration / LONGEST_STEP - 1e-9);
  const double h = duration / num_steps;
  int i;
  for (i = 0; i < num_steps; ++i) {
    OF_MODEL(thrust)(command, h, &rov->thrusters, rov->tau);
    OF_MODEL(step)(&rov->state, rov->tau, h);
  }
  rov->time += duration;
}

/* The line that SITL reads: it has to begin and end with a line feed. Gives its length.
 *
 * The accelerometer stands in the body's origin and shows a - g: dv/dt + omega x v, less gravity
 * seen in the body. Level and at rest it shows -9.80665 along z, which points down.
 */
static int answer_of(const vehicle* rov, char* text, size_t size) {
  const double *v = rov->state.nu, *omega = rov->state.nu + 3, *p = rov->state.position;
  const double x = rov->state.attitude[0], y = rov->state.attitude[1];
  const double z = rov->state.attitude[2], w = rov->state.attitude[3];
  const double down[3] = {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)};
  OF_MODEL(state) rate;
  double accel[3];
  int i;
  OF_MODEL(rate)(&rov->state, rov->tau, &rate);
  for (i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    accel[i] = rate.nu[i] + omega[j] * v[k] - omega[k] * v[j] - GRAVITY * down[i];
  }
  return snprintf(text,
                  size,
                  "\n{\"timestamp\":%.12g,"
                  "\"imu\":{\"gyro\":[%.12g,%.12g,%.12g],\"accel_body\":[%.12g,%.12g,%.12g]},"
                  "\"position\":[%.12g,%.12g,%.12g],"
                  "\"attitude\":[%.12g,%.12g,%.12g],"
                  "\"quaternion\":[%.12g,%.12g,%.12g,%.12g],"
                  "\"velocity\":[%.12g,%.12g,%.12g]}\n",
                  rov->time,
                  omega[0],
                  omega[1],
                  omega[2],
                  accel[0],
                  accel[1],
                  accel[2],
                  p[0],
                  p[1],
                  p[2],
                  atan2(down[1], down[2]),
                  -asin(fmax(-1.0, fmin(1.0, down[0]))),
                  atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z)),
                  w,
                  x,
                  y,
                  z,
                  rate.position[0],
                  rate.position[1],
                  rate.position[2]);
}

static int is_finite(const vehicle* rov) {
  double sum = 0.0;
  int i;
  for (i = 0; i < 6; ++i) sum += rov->state.nu[i];
  for (i = 0; i < 4; ++i) sum += rov->state.attitude[i];
  for (i = 0; i < 3; ++i) sum += rov->state.position[i];
  return isfinite(sum);
}

static double seconds_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* What a frame is to those before it. */
enum order { NEXT, AGAIN, RESTARTED };

static enum order order_of(uint32_t count, int64_t last) {
  if (last < 0 || count == last + 1) return NEXT;
  if (count == last) return AGAIN;
  if (count < last) {
    fprintf(stderr,
            "ardupilot_sitl: frame %lu after %lu: SITL was started again, the vehicle is reset.\n",
            (unsigned long)count,
            (unsigned long)last);
    return RESTARTED;
  }
  fprintf(stderr,
          "ardupilot_sitl: frame %lu after %lu: those between are missing, and not simulated.\n",
          (unsigned long)count,
          (unsigned long)last);
  return NEXT;
}

/* The size of the next packet, for which it waits; below 0 where the socket failed. Says once when
 * nothing comes for a while, after a good packet. */
static ssize_t next_packet(int fd, int* is_silent, unsigned char* bytes, size_t size, sitl* from) {
  for (;;) {
    struct pollfd ready = {fd, POLLIN, 0};
    const int num_ready = poll(&ready, 1, *is_silent ? -1 : SILENCE * 1000);
    if (num_ready > 0) {
      ssize_t received;
      from->size = sizeof from->address;
      received = recvfrom(fd, bytes, size, 0, (struct sockaddr*)&from->address, &from->size);
      if (received >= 0) return received;
    } else if (num_ready == 0) {
      fprintf(stderr,
              "ardupilot_sitl: no packet for %d s. The vehicle stands still until one comes.\n",
              SILENCE);
      *is_silent = 1;
      continue;
    }
    if (errno == EINTR) continue;
    fprintf(stderr, "ardupilot_sitl: cannot receive: %s.\n", strerror(errno));
    return -1;
  }
}

int main(int argc, char** argv) {
  options opts;
  vehicle rov;
  frame in;
  sitl from;
  unsigned char packet[2048];
  char answer[1024];
  int length = 0, is_silent = 1, num_channels = 0, fd;
  int64_t last = -1; /* frame */
  double answered = 0.0;
  if (!read_options(argc, argv, &opts)) return 1;
  fd = open_socket(&opts.port);
  if (fd < 0) {
    fprintf(stderr, "ardupilot_sitl: port %d of 127.0.0.1: %s.\n", opts.port, strerror(errno));
    return 1;
  }
  printf("ardupilot_sitl: waits at 127.0.0.1:%d, %d thrusters at %g V.\n",
         opts.port,
         (int)NUM_THRUSTERS,
         opts.voltage);
  fflush(stdout);
  reset(&rov);
  for (;;) {
    const ssize_t size = next_packet(fd, &is_silent, packet, sizeof packet, &from);
    enum order order;
    if (size < 0) return 1;
    if (!read_frame(packet, (size_t)size, &in)) continue;
    is_silent = 0;
    if (in.num_channels != num_channels) say_missing_channels(in.num_channels, &opts);
    num_channels = in.num_channels;

    order = order_of(in.count, last);
    if (order == AGAIN) {
      /* Frames that queued up while this program was stopped: SITL takes each answer for that of
       * its newest frame, so that one answer to them all is right. */
      if (seconds_now() - answered < RESEND_AFTER) continue;
    } else {
      double command[6];
      if (order == RESTARTED) reset(&rov);
      command_of(&in, &opts, command);
      step(&rov, command, 1.0 / in.rate);
      if (!is_finite(&rov)) {
        fprintf(stderr, "ardupilot_sitl: the model diverged at %g s.\n", rov.time);
        return 1;
      }
      length = answer_of(&rov, answer, sizeof answer);
    }
    last = in.count;
    answered = seconds_now();
    if (sendto(fd, answer, (size_t)length, 0, (struct sockaddr*)&from.address, from.size) !=
        length) {
      fprintf(stderr, "ardupilot_sitl: cannot answer: %s.\n", strerror(errno));
    }
  }
}
