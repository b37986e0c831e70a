"""The lab's server: files of the page, the programming interface, and the processes that compute."""
