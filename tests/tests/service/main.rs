//! Daemon and clients as processes: boot, reloads, events, kills, oversight, trust.

mod doctor;
mod events;
mod first_screen;
mod held;
mod hostile_files;
mod killed_writers;
mod limits;
mod locked;
mod manners;
mod many_maps;
mod observers;
mod observers_hostile;
mod overlays;
mod oversight;
mod patches;
mod processes;
mod proposals;
mod releases;
mod reload_storm;
mod repairs;
mod service;
mod service_trouble;
mod shared;
mod threads;
mod trust;
mod view;
