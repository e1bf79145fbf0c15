#include "core/editing/history.h"

namespace seesaw {

template <int Dim>
void History<Dim>::push(const char* name, Change<Dim> change) {
  if (open_ && fresh_) parked_ = std::move(undone_);
  undone_.clear();
  if (open_ && !fresh_) {
    append(done_.back().change, std::move(change));
    done_.back().state = ++states_;
    return;
  }
  fresh_ = false;
  done_.push_back({name, std::move(change), ++states_});
}

template <int Dim>
const Step<Dim>* History<Dim>::undo(Document<Dim>& document) {
  if (done_.empty()) return nullptr;
  undone_.push_back(std::move(done_.back()));
  done_.pop_back();
  revert_change(undone_.back().change, document);
  return &undone_.back();
}

template <int Dim>
const Step<Dim>* History<Dim>::redo(Document<Dim>& document) {
  if (undone_.empty()) return nullptr;
  done_.push_back(std::move(undone_.back()));
  undone_.pop_back();
  apply_change(done_.back().change, document);
  return &done_.back();
}

template <int Dim>
Change<Dim> History<Dim>::cancel(Document<Dim>& document) {
  open_ = false;
  if (fresh_) return {};
  Change<Dim> change = std::move(done_.back().change);
  done_.pop_back();
  undone_ = std::move(parked_);
  parked_.clear();
  revert_change(change, document);
  return change;
}

template class History<2>;
template class History<3>;

}  // namespace seesaw
