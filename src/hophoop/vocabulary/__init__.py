"""The words, letters, colours and labels of the project, each once: for plots, films, lab, maps and command line."""
