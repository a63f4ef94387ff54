// Checkpoints of a controlled run: the last two passes' frames, the pass that runs, and what is known so far.
#include <algorithm>

#include "simulate/controlled_delivery.h"
#include "simulate/frame_bytes.h"

namespace drape {

namespace {

template <class Record, class Visit>
void each_record_number(Record& record, Visit visit) {
    visit(record.step);
    visit(record.steps);
    visit(record.sweeps);
    visit(record.error_rms);
    visit(record.cpu_seconds);
}

void put_pass(ByteWriter& out, const Pass& pass) {
    out.put(pass.refine);
    out.put(pass.steps);
    out.put(pass.jumps);
    out.put(pass.x.size());
    for (const Points& x : pass.x) out.put(x);
    put_frames(out, pass.frames);
}

Pass take_pass(ByteReader& in) {
    Pass pass;
    pass.refine = in.take<double>();
    pass.steps = in.take<double>();
    pass.jumps = in.take<bool>();
    for (auto count = in.take<size_t>(); count > 0 && in.ok(); --count) pass.x.push_back(in.take_points());
    pass.frames = take_frames(in);
    return pass;
}

// As passes of a run are: positions of all vertices at as many frames as are told of, but for one that went
// wrong.
bool is_whole(const Pass& pass, Eigen::Index vertices, int frames) {
    const auto fits = [&](const Points& x) { return x.cols() == vertices && x.allFinite(); };
    const size_t done = pass.x.size();
    return pass.refine > 0 && pass.refine < 1e9 && done <= static_cast<size_t>(frames) &&
           (pass.frames.size() == done || pass.frames.size() == done + 1 || pass.frames.empty()) &&
           std::all_of(pass.x.begin(), pass.x.end(), fits);
}

void put_list(ByteWriter& out, const std::vector<double>& list) {
    out.put(list.size());
    for (const double value : list) out.put(value);
}

std::vector<double> take_list(ByteReader& in) {
    std::vector<double> list;
    for (auto count = in.take<size_t>(); count > 0 && in.ok(); --count) list.push_back(in.take<double>());
    return list;
}

}  // namespace

std::string ControlledDelivery::save() const {
    ByteWriter out;
    out.put(frames_);
    put_pass(out, before_);
    put_pass(out, now_);
    for (const std::vector<double>* list : {&floor_, &row_steps_, &row_distance_}) put_list(out, *list);
    for (const double value :
         {share_, account_.rms, account_.max, account_.floor, account_.floor_from, account_.seconds})
        out.put(value);
    for (const int value : {row_, idle_, failed_, delivered_}) out.put(value);
    out.put(before_record_);
    out.put(accepted_);
    if (accepted_) out.put(*account_.reached);
    out.put(account_.passes.size());
    for (const PassRecord& record : account_.passes) {
        out.put(record.method);
        out.put(record.purpose);
        each_record_number(record, [&](auto value) { out.put(value); });
    }
    running_->save(out);
    out.put(twin_ != nullptr);
    if (twin_) twin_->save(out);
    return std::move(out).bytes();
}

bool ControlledDelivery::restore(std::string_view bytes) {
    ByteReader in(bytes);
    // passes that ended there have no others
    if (in.take<int>() != frames_) return false;
    Pass before = take_pass(in), now = take_pass(in);
    std::vector<double> floor = take_list(in);
    for (std::vector<double>* list : {&row_steps_, &row_distance_}) *list = take_list(in);
    for (double* value :
         {&share_, &account_.rms, &account_.max, &account_.floor, &account_.floor_from, &account_.seconds})
        *value = in.take<double>();
    for (int* value : {&row_, &idle_, &failed_, &delivered_}) *value = in.take<int>();
    before_record_ = in.take<size_t>();
    accepted_ = in.take<bool>();
    if (accepted_) account_.reached = in.take<bool>();
    std::vector<PassRecord> records;
    for (auto count = in.take<size_t>(); count > 0 && in.ok(); --count) {
        PassRecord& record = records.emplace_back();
        record.method = in.take_text();
        record.purpose = in.take_text();
        each_record_number(record, [&](auto& value) { value = in.take<std::decay_t<decltype(value)>>(); });
    }
    if (!in.ok() || row_ < 0 || static_cast<size_t>(row_) >= rows_.size()) return false;
    const Eigen::Index vertices = shown_.x.cols();
    if (!is_whole(before, vertices, frames_) || !is_whole(now, vertices, frames_)) return false;
    if (delivered_ < 0 || static_cast<size_t>(delivered_) > now.frames.size() ||
        (delivered_ > 0 && !accepted_))
        return false;
    if (row_distance_.size() > row_steps_.size() || row_steps_.size() > row_distance_.size() + 1)
        return false;
    start_pass(now.refine);
    if (!running_->restore(in)) return false;
    twin_.reset();
    if (in.take<bool>()) {
        start_twin();
        if (!twin_->restore(in)) return false;
    }
    floor_ = std::move(floor);
    before_ = std::move(before);
    now_ = std::move(now);
    if (before_record_ >= records.size()) return false;
    account_.passes = std::move(records);
    distance_.clear();
    for (size_t k = 0; k < now_.x.size() && k < before_.x.size(); ++k)
        distance_.push_back(distance_between(now_.x[k], before_.x[k]));
    return in.at_end();
}

}  // namespace drape
