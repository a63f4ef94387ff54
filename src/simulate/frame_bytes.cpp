#include "simulate/frame_bytes.h"

namespace drape {

namespace {

template <class Report, class Visit>
void each_number(Report& report, Visit visit) {
    visit(report.index);
    visit(report.time);
    visit(report.steps);
    visit(report.planned_steps);
    visit(report.retries);
    visit(report.shortest_step);
    visit(report.contacts);
    visit(report.crossings);
    visit(report.least_distance);
    visit(report.strain);
    visit(report.fastest);
    visit(report.cpu_seconds);
    visit(report.error_rms);
    visit(report.error_max);
}

}  // namespace

void put_frames(ByteWriter& out, const std::vector<FrameReport>& frames) {
    out.put(frames.size());
    for (const FrameReport& frame : frames) {
        each_number(frame, [&](auto value) { out.put(value); });
        out.put(frame.hash);
        out.put(frame.trouble);
    }
}

std::vector<FrameReport> take_frames(ByteReader& in) {
    std::vector<FrameReport> frames;
    for (auto count = in.take<size_t>(); count > 0 && in.ok(); --count) {
        FrameReport& frame = frames.emplace_back();
        each_number(frame, [&](auto& value) { value = in.take<std::decay_t<decltype(value)>>(); });
        frame.hash = in.take_text();
        frame.trouble = in.take_text();
    }
    return frames;
}

}  // namespace drape
