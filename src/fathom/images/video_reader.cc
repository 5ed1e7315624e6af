// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/images/video_reader.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/input_error.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/avutil.h>
#include <libswscale/swscale.h>
}

namespace fathom {
namespace {

struct Freer {
  void operator()(AVFormatContext* it) const { avformat_close_input(&it); }
  void operator()(AVCodecContext* it) const { avcodec_free_context(&it); }
  void operator()(AVPacket* it) const { av_packet_free(&it); }
  void operator()(AVFrame* it) const { av_frame_free(&it); }
  void operator()(SwsContext* it) const { sws_freeContext(it); }
};

template <typename T>
using Owned = std::unique_ptr<T, Freer>;

// The file with its largest picture stream.
struct Container {
  Owned<AVFormatContext> format;
  const AVStream* stream = nullptr;
  const AVCodec* decoder = nullptr;

  // Whether there is a next packet of the stream.
  bool Read(AVPacket* packet) const {
    while (true) {
      av_packet_unref(packet);
      const int code = av_read_frame(format.get(), packet);
      if (code == AVERROR(EAGAIN)) continue;
      if (code < 0) return false;
      if (packet->stream_index == stream->index) return true;
    }
  }
};

Container Open(const std::filesystem::path& path) {
  Container it;
  AVFormatContext* format = nullptr;
  // The prefix: no name of a file is taken for an address.
  if (avformat_open_input(&format, ("file:" + path.string()).c_str(), nullptr, nullptr) >= 0) {
    it.format.reset(format);
    if (avformat_find_stream_info(format, nullptr) >= 0) {
      const int index = av_find_best_stream(format, AVMEDIA_TYPE_VIDEO, -1, -1, &it.decoder, 0);
      if (index >= 0) it.stream = format->streams[index];
    }
  }
  if (it.stream == nullptr) {
    throw InputError(path.string() +
                     ": cannot be opened as a video. It is damaged, cut off (an MP4 has its index "
                     "at the end), or of a format that FFmpeg does not know.");
  }
  return it;
}

std::int64_t StampOf(const AVPacket& packet) {
  return packet.pts != AV_NOPTS_VALUE ? packet.pts : packet.dts;
}

// The packets of a container that are frames to be shown.
struct PacketIndex {
  std::vector<std::int64_t> stamps;  // in the order in which they are shown
  std::int64_t num_packets = 0;      // with those that are not shown
};

PacketIndex IndexOf(const Container& container) {
  PacketIndex index;
  const Owned<AVPacket> packet(av_packet_alloc());
  while (container.Read(packet.get())) {
    ++index.num_packets;
    if (packet->size == 0 || (packet->flags & AV_PKT_FLAG_DISCARD) != 0) continue;
    index.stamps.push_back(StampOf(*packet));
  }
  std::sort(index.stamps.begin(), index.stamps.end());
  return index;
}

Owned<AVCodecContext> OpenDecoder(const Container& container) {
  Owned<AVCodecContext> codec(avcodec_alloc_context3(container.decoder));
  codec->thread_count = 0;  // as many as there are processors
  codec->pkt_timebase = container.stream->time_base;
  if (avcodec_parameters_to_context(codec.get(), container.stream->codecpar) < 0 ||
      avcodec_open2(codec.get(), container.decoder, nullptr) < 0) {
    return nullptr;
  }
  return codec;
}

}  // namespace

struct VideoReader::Implementation {
  Container container;
  PacketIndex packets;
  Owned<AVCodecContext> codec;
  Owned<AVPacket> packet{av_packet_alloc()};
  Owned<AVFrame> frame{av_frame_alloc()};
  Owned<AVFrame> colours{av_frame_alloc()};
  Owned<SwsContext> scaler;
  std::size_t next_index = 0;
  double time = 0.0;  // [s]
  std::size_t num_errors = 0;

  // The next frame that can be decoded; false at the end.
  bool Decode() {
    while (true) {
      const int code = avcodec_receive_frame(codec.get(), frame.get());
      if (code >= 0) return true;
      if (code == AVERROR_EOF) return false;
      // One error for a packet at the most: more would have no end.
      if (code != AVERROR(EAGAIN) && ++num_errors > packets.stamps.size()) return false;
      if (code != AVERROR(EAGAIN)) continue;
      // What the decoder does not take is a frame that is missing.
      const bool has_packet = container.Read(packet.get());
      avcodec_send_packet(codec.get(), has_packet ? packet.get() : nullptr);
    }
  }

  // The place of the frame's packet; the next in order for a stamp that no packet has.
  void Count() {
    auto& stamps = packets.stamps;
    const auto next = stamps.begin() + std::min(next_index, stamps.size());
    const auto found = std::lower_bound(next, stamps.end(), frame->best_effort_timestamp);
    if (found != stamps.end() && *found == frame->best_effort_timestamp) {
      next_index = found - stamps.begin();
    }
    ++next_index;
  }

  double TimeOfFrame() const {
    const AVStream& stream = *container.stream;
    const std::int64_t stamp = frame->best_effort_timestamp;
    if (stamp == AV_NOPTS_VALUE) return 0.0;
    const std::int64_t start = stream.start_time == AV_NOPTS_VALUE ? 0 : stream.start_time;
    return static_cast<double>(stamp - start) * av_q2d(stream.time_base);
  }

  // By way of colours, which gives the grey values of OpenCV's own reader.
  bool ToGray(GrayImage* image) {
    av_frame_unref(colours.get());
    colours->format = AV_PIX_FMT_BGR24;
    colours->width = frame->width;
    colours->height = frame->height;
    if (av_frame_get_buffer(colours.get(), 0) < 0) return false;
    scaler.reset(sws_getCachedContext(scaler.release(),
                                      frame->width,
                                      frame->height,
                                      static_cast<AVPixelFormat>(frame->format),
                                      frame->width,
                                      frame->height,
                                      AV_PIX_FMT_BGR24,
                                      SWS_BICUBIC,
                                      nullptr,
                                      nullptr,
                                      nullptr));
    if (scaler == nullptr || sws_scale(scaler.get(),
                                       frame->data,
                                       frame->linesize,
                                       0,
                                       frame->height,
                                       colours->data,
                                       colours->linesize) != frame->height) {
      return false;
    }
    const cv::Mat bgr(frame->height, frame->width, CV_8UC3, colours->data[0], colours->linesize[0]);
    *image = GrayImage(frame->width, frame->height);
    cv::Mat gray(image->height, image->width, CV_8U, image->pixels.data());
    cv::cvtColor(bgr, gray, cv::COLOR_BGR2GRAY);
    return true;
  }
};

VideoReader::VideoReader(const std::filesystem::path& path)
    : implementation_(std::make_unique<Implementation>()) {
  RequireRegularFile(path);
  // FFmpeg's own words on stderr name no file; ours follow from what it returns.
  av_log_set_level(AV_LOG_QUIET);
  Implementation& it = *implementation_;
  it.packets = IndexOf(Open(path));
  it.container = Open(path);
  it.codec = OpenDecoder(it.container);
  if (it.codec == nullptr || it.packets.stamps.empty()) {
    throw InputError(path.string() +
                     ": holds no frame that can be decoded. It is damaged, cut off, or of a format "
                     "that FFmpeg does not know.");
  }
}

VideoReader::~VideoReader() = default;
VideoReader::VideoReader(VideoReader&&) noexcept = default;
VideoReader& VideoReader::operator=(VideoReader&&) noexcept = default;

int VideoReader::num_frames() const {
  return static_cast<int>(implementation_->packets.stamps.size());
}

int VideoReader::num_announced() const {
  const Implementation& it = *implementation_;
  constexpr std::int64_t kMost = 1'000'000'000;  // more is a header that is damaged
  const std::int64_t num_lacking = it.container.stream->nb_frames - it.packets.num_packets;
  return num_frames() +
         (num_lacking > 0 && num_lacking < kMost ? static_cast<int>(num_lacking) : 0);
}

double VideoReader::duration() const {
  const Container& container = implementation_->container;
  const std::int64_t duration = container.format->duration;
  if (duration == AV_NOPTS_VALUE || container.stream->nb_frames > 0) return 0.0;
  return static_cast<double>(duration) / AV_TIME_BASE;
}

double VideoReader::mean_rate() const {
  const Implementation& it = *implementation_;
  const auto& stamps = it.packets.stamps;
  const auto ticks = static_cast<double>(stamps.back() - stamps.front());
  if (!(ticks > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return (num_frames() - 1) / (ticks * av_q2d(it.container.stream->time_base));
}

bool VideoReader::Next(GrayImage* image) {
  Implementation& it = *implementation_;
  do {
    if (!it.Decode()) return false;
    it.Count();
  } while (!it.ToGray(image));
  it.time = it.TimeOfFrame();
  return true;
}

int VideoReader::index() const { return static_cast<int>(implementation_->next_index) - 1; }

double VideoReader::time() const { return implementation_->time; }

}  // namespace fathom
